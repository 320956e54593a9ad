// A log of 300 MB: how soon it is seen, and how quickly sought.
import {mkdtempSync, readdirSync, readlinkSync, rmSync, statSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {kRepository, Process, run} from '../lib/process.mjs';
import {quantile} from '../lib/report.mjs';
import {must} from '../lib/wait.mjs';
import {WebSocketPeer} from '../web_socket.mjs';

const kMegabytes = 300;
const kSeeks = 100;

// A recording of the demo, cut to the size.
async function recording(folder) {
  const said = await run([`${kRepository}/scripts/demo`, '--no-page', '--lockstep', '--drive'],
    {env: {...process.env, MARKSERVO_DEMO_BUILT: 'yes'}});
  const made = `${kRepository}/${/goes to (\S+)/.exec(said)[1]}`;
  const log = `${made}/log.lcm`;
  const info = JSON.parse(await run([`${kRepository}/scripts/log`, 'info', '--json', log]));
  const seconds = (info.seconds * kMegabytes * 1e6) / statSync(log).size;
  await run([`${kRepository}/scripts/log`, 'cut', log, `${folder}/cut.lcm`, '--to', String(seconds)]);
  rmSync(made, {recursive: true});
  return `${folder}/cut.lcm`;
}

// A client that says how long the next picture took.
class Viewer {
  constructor(place) {
    this.pictures = 0;
    this.hello = null;
    this.peer = new WebSocketPeer(place, (self) => {
      self.say({type: 'hello', protocol: 1});
      self.say({type: 'pictures', on: true});
    }, (isText, payload) => this.hear(isText, payload));
  }

  hear(isText, payload) {
    if (!isText) {
      const header = JSON.parse(payload.subarray(4, 4 + payload.readUInt32LE(0)).toString());
      this.peer.say({type: 'seen', number: header.number});
      this.last = header;
      ++this.pictures;
      this.waiting?.();
      return;
    }
    const message = JSON.parse(payload.toString());
    if (message.type === 'hello') this.hello = message;
    if (message.number !== undefined) this.peer.say({type: 'took', number: message.number});
  }

  // s, from asking for the instant to its picture.
  async seek(utime) {
    const begun = process.hrtime.bigint();
    const came = new Promise((resolve) => (this.waiting = resolve));
    this.peer.say({type: 'seek', utime: String(utime)});
    await came;
    return Number(process.hrtime.bigint() - begun) / 1e9;
  }
}

function socketsOf(pid) {
  const descriptors = readdirSync(`/proc/${pid}/fd`).flatMap((name) => {
    try {
      return [readlinkSync(`/proc/${pid}/fd/${name}`)];
    } catch {
      return [];
    }
  });
  return descriptors.filter((target) => target.startsWith('socket:')).map((target) => /\d+/.exec(target)[0]);
}

async function udpSocketsOf(pid) {
  const own = new Set(socketsOf(pid));
  const lines = (await run(['cat', '/proc/net/udp', '/proc/net/udp6'])).split('\n');
  return lines.filter((line) => own.has(line.trim().split(/\s+/)[9])).length;
}

export async function measure(report, {bin}) {
  const folder = mkdtempSync(join(tmpdir(), 'bench-page-'));
  try {
    const log = await recording(folder);
    report.add('the log, MB', statSync(log).size / 1e6, null, null);
    const begun = Date.now();
    const server = new Process([`${bin}/mmi`, '--log', log, '--listen', `${folder}/page.sock`]);
    let viewer = null;
    await must('the first picture', () => {
      if (!viewer && readdirSync(folder).includes('page.sock')) viewer = new Viewer({path: `${folder}/page.sock`});
      return viewer !== null && viewer.pictures > 0;
    }, 30, 5);
    const first = (Date.now() - begun) / 1000;
    report.add('from the start of mmi to the first picture, s', first, '2', first <= 2);
    const from = Number(viewer.last.at);
    const to = Number(viewer.hello.log.end);
    const times = [];
    for (let i = 0; i < kSeeks; ++i) times.push(await viewer.seek(Math.round(from + ((to - from) * ((i * 37) % kSeeks)) / kSeeks)));
    report.add('seek, median, s', quantile(times, 0.5), null, null);
    report.add('seek, p95, s', quantile(times, 0.95), '0.2', quantile(times, 0.95) <= 0.2, {times});
    const udp = await udpSocketsOf(server.pid);
    report.add('UDP sockets', udp, '0', udp === 0);
    viewer.peer.vanish();
    await server.end();
  } finally {
    rmSync(folder, {recursive: true, force: true});
  }
}
