// The page in a real browser, measured. scripts/bench page runs it on a private network.
// usage: main.mjs --bin DIR --out DIR [CASE...]
import {realpathSync} from 'node:fs';
import {parseArgs} from 'node:util';
import {endAll} from './lib/process.mjs';
import {Report} from './lib/report.mjs';

const kCases = ['truth', 'troubles', 'stop', 'access', 'paint', 'clients', 'memory', 'log', 'hostile'];

const {values, positionals} = parseArgs({
  allowPositionals: true,
  options: {bin: {type: 'string'}, out: {type: 'string'}, rounds: {type: 'string', default: '200'}},
});
const bin = realpathSync(values.bin);
let good = true;
for (const name of positionals.length > 0 ? positionals : kCases) {
  const {measure} = await import(`./cases/${name}.mjs`);
  const report = new Report(name, values.out);
  try {
    await measure(report, {bin, out: values.out, rounds: Number(values.rounds)});
  } catch (error) {
    report.add('could be measured', error.message, null, false);
    console.error(error);
  }
  await endAll();
  good = report.end() && good;
}
process.exit(good ? 0 : 1);
