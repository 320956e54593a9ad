// Bundles each test with what it tests, and runs them all with node's own runner.
import {spawnSync} from 'node:child_process';
import {mkdtempSync, readdirSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {dirname, join} from 'node:path';
import {fileURLToPath} from 'node:url';
import {build} from 'esbuild';

const here = dirname(fileURLToPath(import.meta.url));
const out = mkdtempSync(join(tmpdir(), 'mmi-page-test-'));
const tests = readdirSync(here).filter((name) => name.endsWith('_test.ts'));
try {
  await build({
    entryPoints: tests.map((name) => join(here, name)),
    outdir: out,
    bundle: true,
    platform: 'node',
    format: 'esm',
    target: 'node18',
    outExtension: {'.js': '.mjs'},
    sourcemap: 'inline',
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
