// The demo's task in lockstep, as scripts/demo has it, with the page at a port of this network and a recording.
import {mkdirSync, mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {kRepository, Process, run} from './process.mjs';
import {must} from './wait.mjs';

// What the simulated time waits for.
const kAwaited = 'JOINT_COMMAND,TASK_STATE,ROBOT_POSE,BASE_COMMAND,SIM_CONTROL';
const kBeforeDock_m = 1;

function dock() {
  const path = `${kRepository}/config/scenes/shelf.yaml`;
  const pose = /^dock:[^]*?\n +pose: \[(.*?)\]/m.exec(readFileSync(path, 'utf8'));
  if (!pose) throw new Error(`${path}: has no dock with a pose`);
  return pose[1].split(',').map(Number);
}

export class RecordedRun {
  constructor({bin, seed, port = 8080}) {
    this.bin = bin;
    this.seed = seed;
    this.port = port;
    this.address = `http://127.0.0.1:${port}`;
    this.folder = mkdtempSync(join(tmpdir(), 'bench-page-'));
    this.log = `${this.folder}/recording`;
  }

  /** The stack is up, and its simulated time waits for the referee. */
  async start() {
    mkdirSync(this.log);
    this.recorder = new Process([`${kRepository}/scripts/record`, '--out', this.log, '--note', `bench page truth, seed ${this.seed}`]);
    await must('recording', () => {
      if (this.recorder.code !== undefined) throw new Error(this.recorder.said);
      return /^recording /m.test(this.recorder.said);
    }, 20);
    const [x, y, heading_deg] = dock();
    const heading = (heading_deg * Math.PI) / 180;
    const places = {'base.start_x': (x - kBeforeDock_m * Math.cos(heading)).toFixed(4),
      'base.start_y': (y - kBeforeDock_m * Math.sin(heading)).toFixed(4), 'base.start_heading_deg': heading_deg};
    const settings = Object.entries(places).map(([name, value]) => `--set ${name}=${value}`).join(' ');
    await this.ask('start', '--build-dir', join(this.bin, '..'), '--log-dir', `${this.folder}/services`, '--may-wait',
      '--simulator-args', `--seed ${this.seed} ${settings} --lockstep --wait-for ${kAwaited}`,
      '--args', 'mmi', `--listen 127.0.0.1:${this.port}`);
  }

  ask(action, ...options) {
    return run([`${kRepository}/scripts/stack`, action, '--runtime-dir', `${this.folder}/run`, ...options]);
  }

  /** Begins the task: its process, which ends with it. */
  begin() {
    return new Process([`${this.bin}/demo-referee`, '--target', 'red_book', '--seed', String(this.seed), '--out', this.folder,
      '--robot-file', 'config/robot.yaml', '--lockstep', '--drive', dock().join()]);
  }

  /** Ends the recording, then the stack. */
  async end() {
    await this.recorder?.end();
    await this.ask('stop').catch(() => {});
  }

  remove() {
    rmSync(this.folder, {recursive: true, force: true});
  }
}
