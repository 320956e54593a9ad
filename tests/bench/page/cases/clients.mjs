// What ten clients cost the robot, direct and through the forwarder, and what mmi itself takes.
import {spawn} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {kRepository, Process, run} from '../lib/process.mjs';
import {quantile} from '../lib/report.mjs';
import {pause} from '../lib/wait.mjs';

const kRounds = 5;
const kSeconds = 6; // of each kind of frames, in a round
const kShareSeconds = 20;
const kCrowdSeconds = 60;
const kTicksPerSecond = 100; // of /proc/PID/stat
const kQuickRate = 15; // Hz, as mmi sends at most

async function latency(bin) {
  // What it says of its progress is on the standard error.
  const child = spawn(`${bin}/latency-bench`, ['--bin', bin, '--robot-file', `${kRepository}/config/robot.yaml`,
    '--seconds', String(kSeconds), '--json'], {stdio: ['ignore', 'pipe', 'ignore']});
  let said = '';
  for await (const bytes of child.stdout) said += bytes;
  return JSON.parse(said).raw_30.chain_p99_ms;
}

function mmi(bin, folder) {
  return new Process([`${bin}/mmi`, '--listen', `${folder}/page.sock`]);
}

// A crowd of clients for `seconds`, direct or through a forwarder.
class Crowd {
  constructor(folder, forwarded, seconds, ...options) {
    const place = forwarded ? ['--port', '8099'] : ['--path', `${folder}/page.sock`];
    this.forwarder = forwarded ? new Process(['socat', 'TCP-LISTEN:8099,bind=127.0.0.1,reuseaddr,fork,backlog=128,max-children=80',
      `UNIX-CONNECT:${folder}/page.sock`]) : null;
    this.ready = pause(300).then(() => {
      this.process = new Process(['node', `${kRepository}/tests/bench/page/crowd.mjs`, String(seconds), ...place, ...options]);
    });
  }

  // What it says at its end.
  async told() {
    await this.ready;
    await this.process.ended;
    await this.forwarder?.end();
    return JSON.parse(this.process.said.trim().split('\n').pop());
  }

  async end() {
    await this.ready;
    await this.process.end();
    await this.forwarder?.end();
  }
}

// MB, the most that it has had.
function peakOf(process) {
  return Number(/VmHWM:\s*(\d+)/.exec(readFileSync(`/proc/${process.pid}/status`, 'utf8'))[1]) / 1024;
}

// Frame to command, p99 in ms, beside a page that nobody looks at.
async function latencyWithoutClients(bin, folder) {
  const server = mmi(bin, folder);
  await pause(2000);
  const figure = await latency(bin);
  await server.end();
  return figure;
}

// The same with a crowd at work.
async function latencyInACrowd(bin, folder, forwarded) {
  const server = mmi(bin, folder);
  await pause(500);
  const crowd = new Crowd(folder, forwarded, 3600);
  await pause(1500);
  const figure = await latency(bin);
  await crowd.end();
  await server.end();
  return figure;
}

function ticks(pid) {
  const fields = readFileSync(`/proc/${pid}/stat`, 'utf8').replace(/^.*\) /, '').split(' ');
  return Number(fields[11]) + Number(fields[12]);
}

async function share(pid) {
  const before = ticks(pid);
  await pause(1000 * kShareSeconds);
  return (100 * (ticks(pid) - before)) / kTicksPerSecond / kShareSeconds;
}

// Frames at 30 Hz and what finds marks in them, without a pause.
class Frames {
  constructor(bin, folder) {
    this.processes = [
      new Process([`${bin}/stereo-camera`, '--input', `${folder}/pair.png`, '--side-by-side', '--fx', '784', '--baseline', '0.065',
        '--rate', '30', '--loop']),
      ...['mark-detector', 'target-locator'].map((name) => new Process([`${bin}/${name}`])),
    ];
  }
  end() {
    return Promise.all(this.processes.map((process) => process.end()));
  }
}

async function measureShares(bin, folder, report) {
  const server = mmi(bin, folder);
  await pause(2000);
  const none = await share(server.pid);
  const viewer = new Crowd(folder, false, 3600, '1');
  await pause(2000);
  const one = await share(server.pid);
  await viewer.end();
  await server.end();
  report.add('processor share without a viewer, raw frames at 30 Hz, %', none, '8', none <= 8);
  report.add('processor share with one viewer at 15 Hz, %', one, '15', one <= 15);
}

async function measureRates(bin, folder, forwarded, report) {
  const way = forwarded ? 'through the forwarder' : 'direct';
  const server = mmi(bin, folder);
  await pause(500);
  const told = await new Crowd(folder, forwarded, kCrowdSeconds).told();
  const peak = peakOf(server);
  await server.end();
  const slowest = Math.min(...told.pictures_per_s);
  report.add(`slowest quick client, ${way}, pictures/s`, slowest, `95% of ${kQuickRate}`, slowest >= 0.95 * kQuickRate, told);
  const fresh = told.fresh_after_stall_s ?? Infinity;
  report.add(`a picture under 0.5 s old after a stall, ${way}, s`, fresh, '0.5', fresh <= 0.5);
  report.add(`mmi's memory, ${way}, MB`, peak, '300', peak < 300);
}

async function measureLatency(bin, folder, forwarded, report) {
  const rounds = [];
  for (let i = 0; i < kRounds; ++i) {
    const alone = await latencyWithoutClients(bin, folder);
    const in_a_crowd = await latencyInACrowd(bin, folder, forwarded);
    rounds.push({alone, in_a_crowd, ratio: in_a_crowd / alone});
  }
  const ratio = quantile(rounds.map((round) => round.ratio), 0.5);
  const way = forwarded ? 'through the forwarder' : 'direct';
  report.add(`frame to command p99, ten clients beside none, ${way}, median of ${kRounds}`, ratio, 'at most 1.25', ratio <= 1.25, {rounds});
}

export async function measure(report, {bin}) {
  const folder = mkdtempSync(join(tmpdir(), 'bench-page-'));
  try {
    await run([`${bin}/simulator`, '--robot-file', `${kRepository}/config/robot.yaml`, '--scene',
      `${kRepository}/config/scenes/shelf.yaml`, '--snapshot', `${folder}/pair.png`]);
    const frames = new Frames(bin, folder);
    await measureShares(bin, folder, report);
    for (const forwarded of [false, true]) await measureRates(bin, folder, forwarded, report);
    await frames.end();
    for (const forwarded of [false, true]) await measureLatency(bin, folder, forwarded, report);
  } finally {
    rmSync(folder, {recursive: true, force: true});
  }
}
