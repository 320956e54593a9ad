// Bundles each test with what it tests, and runs them all with node's own runner. Exit code 77: npm has not laid down what
// that takes.
import {spawnSync} from 'node:child_process';
import {mkdtempSync, readdirSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {lcmTypes} from '../lcm_types.mjs';

const kSkipped = 77;
const esbuild = await import('esbuild').catch(() => null);
if (esbuild === null) {
  console.error('esbuild is not there: services/mmi/page/build brings it');
  process.exit(kSkipped);
}

const here = dirname(fileURLToPath(import.meta.url));
const out = mkdtempSync(join(tmpdir(), 'mmi-page-test-'));
const tests = readdirSync(here).filter((name) => name.endsWith('_test.ts'));
try {
  await esbuild.build({
    entryPoints: tests.map((name) => join(here, name)),
    outdir: out,
    bundle: true,
    platform: 'node',
    format: 'esm',
    target: 'node18',
    outExtension: {'.js': '.mjs'},
    sourcemap: 'inline',
    plugins: [lcmTypes],
    loader: {'.cpp': 'text'},
    logLevel: 'error',
  });
  const run = spawnSync(
    process.execPath,
    ['--enable-source-maps', '--test', ...tests.map((name) => join(out, name.replace('.ts', '.mjs')))],
    {stdio: 'inherit'},
  );
  process.exitCode = run.status ?? 1;
} finally {
  rmSync(out, {recursive: true, force: true});
}
