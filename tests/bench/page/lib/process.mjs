// Processes of the measurement's own: each ends with it.
import {spawn} from 'node:child_process';
import {readdirSync, readFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';

export const kRepository = fileURLToPath(new URL('../../../..', import.meta.url)).replace(/\/$/, '');

const running = new Set();

export class Process {
  constructor(command, options = {}) {
    this.said = '';
    this.child = spawn('setpriv', ['--pdeathsig', 'TERM', '--', ...command], {cwd: kRepository, stdio: ['ignore', 'pipe', 'pipe'], ...options});
    this.code = undefined;
    for (const stream of [this.child.stdout, this.child.stderr]) stream.on('data', (bytes) => (this.said += bytes));
    running.add(this);
    this.ended = new Promise((resolve) => this.child.on('close', (code) => {
      this.code = code;
      running.delete(this);
      resolve(code);
    }));
  }

  get pid() {
    return this.child.pid;
  }

  end(signal = 'SIGTERM') {
    this.child.kill(signal);
    return this.ended;
  }
}

/** Runs it to its end: what it said. Throws where it fails, unless `may_fail`. */
export async function run(command, {may_fail = false, ...options} = {}) {
  const process = new Process(command, options);
  const code = await process.ended;
  if (code !== 0 && !may_fail) throw new Error(`${command.join(' ')}: exit code ${code}: ${process.said.slice(-2000)}`);
  return process.said;
}

export async function endAll() {
  await Promise.all([...running].map((process) => process.end()));
}

/** The newest process whose command line matches, of this network; null: none. */
export function processOf(pattern) {
  const found = readdirSync('/proc').filter((name) => /^\d+$/.test(name)).map(Number).filter((pid) => {
    try {
      return pattern.test(readFileSync(`/proc/${pid}/cmdline`, 'utf8').replaceAll('\0', ' '));
    } catch {
      return false;
    }
  });
  return found.length > 0 ? Math.max(...found) : null;
}
