// Builds the page: `services/mmi/page/build OUT` writes OUT/index.html, OUT/icon.svg, OUT/app.js and OUT/app.css.
// Exit code 2: no folder given, 3: npm is missing or reaches no registry, 1: the page does not build.
import {spawnSync} from 'node:child_process';
import {existsSync, mkdirSync, mkdtempSync, readdirSync, renameSync, rmSync, copyFileSync, statSync} from 'node:fs';
import {dirname, join, resolve} from 'node:path';
import {fileURLToPath} from 'node:url';
import {lcmTypes} from './lcm_types.mjs';

const here = dirname(fileURLToPath(import.meta.url));
const kNoRegistry = 3;

function fail(code, text) {
  process.stderr.write(`page/build: ${text}\n`);
  process.exit(code);
}

/** What npm installed, and when it was last told to: npm writes this file at the end. */
function installedIsCurrent() {
  const installed = join(here, 'node_modules', '.package-lock.json');
  return existsSync(installed) && statSync(installed).mtimeMs >= statSync(join(here, 'package-lock.json')).mtimeMs;
}

function install() {
  const npm = spawnSync('npm', ['ci', '--no-audit', '--no-fund', '--fetch-retries=1', '--fetch-timeout=60000'], {
    cwd: here,
    encoding: 'utf8',
  });
  if (npm.error) fail(kNoRegistry, `npm cannot be run (${npm.error.code}); the page is not built`);
  if (npm.status === 0) return;
  rmSync(join(here, 'node_modules'), {recursive: true, force: true});
  const why = /npm (?:error|ERR!) code (\S+)/.exec(npm.stderr)?.[1] ?? `code ${npm.status}`;
  fail(kNoRegistry, `npm ci could not fetch the page's packages (${why}); the page is not built`);
}

function checkTypes() {
  const tsc = spawnSync(process.execPath, [join(here, 'node_modules/typescript/bin/tsc'), '--noEmit'], {
    cwd: here,
    encoding: 'utf8',
  });
  if (tsc.status !== 0) fail(1, `type errors\n${tsc.stdout}${tsc.stderr}`);
}

async function bundle(folder) {
  const {build} = await import('esbuild');
  await build({
    absWorkingDir: here,
    entryPoints: {app: 'src/main.ts'},
    outdir: folder,
    bundle: true,
    minify: true,
    format: 'iife',
    target: ['chrome110', 'firefox115', 'safari16'],
    legalComments: 'eof',
    plugins: [lcmTypes],
    logLevel: 'error',
  });
  for (const name of ['index.html', 'icon.svg']) copyFileSync(join(here, 'src', name), join(folder, name));
}

if (process.argv.length !== 3) fail(2, 'usage: services/mmi/page/build OUT');
const out = resolve(process.argv[2]);
if (!installedIsCurrent()) install();
checkTypes();
mkdirSync(out, {recursive: true});
const half = mkdtempSync(join(out, '.building-'));
try {
  await bundle(half);
  for (const name of readdirSync(half)) renameSync(join(half, name), join(out, name));
} catch (error) {
  process.stderr.write(`page/build: ${error.message}\n`);
  process.exitCode = 1;
} finally {
  rmSync(half, {recursive: true, force: true});
}
