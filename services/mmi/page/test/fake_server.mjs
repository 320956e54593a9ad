// Speaks the page's protocol with an invented robot: node test/fake_server.mjs FOLDER_OF_THE_PAGE PORT live|log
// [trouble|commands]; who has the token 'fake' commands. Run it inside scripts/private-network.
import {createHash} from 'node:crypto';
import {readFileSync} from 'node:fs';
import {createServer} from 'node:http';
import {extname, join} from 'node:path';
import {FakeDesk} from './fake_desk.mjs';
import {events, hello, kBegin, picture, update} from './fake_robot.mjs';

const [folder, port, mode = 'live', further = ''] = process.argv.slice(2);
const trouble = further !== '' && further !== 'commands';
const kTypes = {'.html': 'text/html; charset=utf-8', '.js': 'text/javascript', '.css': 'text/css'};
const kPolicy =
  "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; connect-src 'self'; font-src 'none'; " +
  "base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
const kLogSeconds = 90;

const server = createServer((request, response) => {
  const path = request.url.split('?')[0] === '/' ? '/index.html' : request.url.split('?')[0];
  try {
    if (!/^\/[a-z]+\.[a-z]+$/.test(path)) throw new Error('no such file');
    const content = readFileSync(join(folder, path));
    response.writeHead(200, {
      'Content-Type': kTypes[extname(path)] ?? 'application/octet-stream',
      'Content-Security-Policy': kPolicy,
    });
    response.end(content);
  } catch {
    response.writeHead(404).end();
  }
});

const started = Date.now();
const seconds = () => (Date.now() - started) / 1000 + 20;
let stop_at = null;

server.on('upgrade', (request, socket) => {
  const accept = createHash('sha1')
    .update(`${request.headers['sec-websocket-key']}258EAFA5-E914-47DA-95CA-C5AB0DC85B11`)
    .digest('base64');
  socket.write(
    `HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${accept}\r\n\r\n`,
  );
  converse(socket);
});

function send(socket, data) {
  const binary = Buffer.isBuffer(data);
  const body = binary ? data : Buffer.from(JSON.stringify(data));
  const head =
    body.length < 126 ? Buffer.from([0, body.length]) : body.length < 65536 ? Buffer.alloc(4) : Buffer.alloc(10);
  head[0] = 0x80 | (binary ? 2 : 1);
  if (head.length === 4) {
    head[1] = 126;
    head.writeUInt16BE(body.length, 2);
  }
  if (head.length === 10) {
    head[1] = 127;
    head.writeBigUInt64BE(BigInt(body.length), 2);
  }
  socket.write(Buffer.concat([head, body]));
}

/** Calls `hear` with each text that the client sends. */
function listen(socket, hear) {
  let waiting = Buffer.alloc(0);
  socket.on('data', (data) => {
    waiting = Buffer.concat([waiting, data]);
    while (waiting.length >= 6) {
      const short = waiting[1] & 127;
      const size = short === 126 ? waiting.readUInt16BE(2) : short;
      const begin = short === 126 ? 8 : 6;
      if (waiting.length < begin + size) return;
      const mask = waiting.subarray(begin - 4, begin);
      const text = Buffer.from(waiting.subarray(begin, begin + size).map((byte, i) => byte ^ mask[i & 3])).toString();
      if ((waiting[0] & 15) === 8) socket.end();
      else if ((waiting[0] & 15) === 1) hear(JSON.parse(text));
      waiting = waiting.subarray(begin + size);
    }
  });
}

function converse(socket) {
  const client = {
    look: null,
    updates: 0,
    pictures: false,
    sent: 0,
    seen: 0,
    told: -1,
    second: -1,
    play: {at: 0, playing: false, speed: 1},
    anew: false,
    stop: '',
  };
  const now = () => (mode === 'log' ? client.play.at : seconds());
  const robot = {latched: () => stop_at !== null, reset: () => (stop_at = null)};
  const desk = further === 'commands' ? new FakeDesk(robot) : null;
  let ticking = null;
  listen(socket, (message) => {
    desk?.hear(message, kBegin + seconds() * 1e6);
    if (message.type === 'hello') {
      const all = mode === 'log' ? events(-1, kLogSeconds) : events(-1, seconds());
      send(socket, hello(mode, kLogSeconds, all));
      client.told = mode === 'log' ? kLogSeconds : seconds();
      ticking = setInterval(tick, 50);
    }
    if (message.type === 'look') client.look = new Set(message.channels);
    if (message.type === 'pictures') client.pictures = message.on;
    if (message.type === 'seen') client.seen = message.number;
    if (message.type === 'stop') stop_at = Date.now();
    if (message.type === 'play') Object.assign(client.play, {playing: true, speed: message.speed});
    if (message.type === 'pause') client.play.playing = false;
    if (message.type === 'seek')
      Object.assign(client.play, {at: (Number(message.utime) - kBegin) / 1e6}, ((client.anew = true), {}));
    if (message.type === 'step') client.play.at += message.by / 10;
  });
  const tick = () => {
    if (client.play.playing) client.play.at = Math.min(kLogSeconds, client.play.at + 0.05 * client.play.speed);
    const t = now();
    const message = update(t, client.look, Math.floor(Date.now() / 1000) !== client.second);
    client.second = Math.floor(Date.now() / 1000);
    if (client.anew) message.anew = true;
    client.anew = false;
    if (mode === 'log') {
      message.play = {
        utime: String(Math.round(kBegin + t * 1e6)),
        playing: client.play.playing,
        speed: client.play.speed,
      };
    } else {
      message.events = events(client.told, t);
      client.told = t;
      const after = stop_at === null ? -1 : Date.now() - stop_at;
      const state = after < 0 ? 'idle' : after < 300 ? 'requested' : trouble ? 'silent' : 'acknowledged';
      message.stop = {
        state: state === 'silent' ? 'requested' : state,
        devices: [
          {
            device: 'arm',
            state: after < 150 ? state : after < 0 ? 'idle' : 'acknowledged',
            latched: after >= 0,
            reason: '',
          },
          {device: 'base', state, latched: after >= 0, reason: ''},
        ],
      };
    }
    message.troubles = trouble
      ? [
          {
            code: 'camera_silent',
            subject: 'stereo-camera',
            since_utime: String(kBegin),
            text: 'No picture from stereo-camera for 4.2 s.',
            remedy: 'Check its cable, then scripts/stack restart stereo-camera.',
          },
          {
            code: 'process_dead',
            subject: 'mark-detector',
            since_utime: String(kBegin),
            text: '<b>mark-detector</b> is not running.',
            remedy: 'scripts/stack status',
          },
        ]
      : [];
    Object.assign(message, desk?.parts());
    message.number = ++client.updates;
    send(socket, message);
    if (client.pictures && client.sent - client.seen < 2 && Math.round(t * 20) % 2 === 0)
      send(socket, picture(t, ++client.sent));
  };
  const end = () => {
    clearInterval(ticking);
    desk?.leave();
  };
  socket.on('close', end);
  socket.on('error', end);
}

server.listen(Number(port), '127.0.0.1');
