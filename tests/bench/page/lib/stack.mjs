// A simulated robot with its page at a port of this network.
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {kRepository, processOf, run} from './process.mjs';

export class Stack {
  /** `start_at`: settings of the simulator. */
  constructor({bin, port = 8080, settings = [], robot_file = null}) {
    this.folder = mkdtempSync(join(tmpdir(), 'bench-page-'));
    this.bin = bin;
    this.address = `http://127.0.0.1:${port}`;
    this.settings = settings;
    this.robot_file = robot_file;
  }

  ask(action, ...options) {
    return run([`${kRepository}/scripts/stack`, action, '--runtime-dir', `${this.folder}/run`, ...options]);
  }

  start() {
    const simulator = this.settings.map((setting) => `--set ${setting}`).join(' ');
    const robot = this.robot_file ? ['--robot-file', this.robot_file] : [];
    return this.ask('start', '--build-dir', join(this.bin, '..'), '--log-dir', `${this.folder}/logs`, '--simulator-args', simulator,
      '--args', 'mmi', `--listen ${this.address.replace('http://', '')}`, ...robot);
  }

  async stop() {
    await this.ask('stop').catch(() => {});
    rmSync(this.folder, {recursive: true, force: true});
  }

  pidOf(service) {
    return processOf(new RegExp(`^${this.bin}/${service} `));
  }
}

/** Tells the robot what to do; whatever becomes of it. */
export function task(...words) {
  return run([`${kRepository}/scripts/task`, ...words], {may_fail: true});
}

/** Changes the simulated world, at once. */
export function setWorld(bin, ...words) {
  return run([`${bin}/simulator-set`, ...words]);
}
