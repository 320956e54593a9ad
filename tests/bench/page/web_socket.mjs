// A WebSocket's client (RFC 6455) by node's own sockets: one that can stall, dribble or vanish, as browsers' cannot.
import {connect} from 'node:net';
import {randomBytes} from 'node:crypto';

const kText = 1;
const kBinary = 2;
const kClose = 8;
const kPing = 9;
const kPong = 10;

function masked(opcode, payload) {
  const key = randomBytes(4);
  const length = payload.length < 126 ? Buffer.from([0x80 | payload.length])
    : Buffer.from([0x80 | 126, payload.length >> 8, payload.length & 0xff]);
  const body = Buffer.from(payload);
  for (let i = 0; i < body.length; ++i) body[i] ^= key[i % 4];
  return Buffer.concat([Buffer.from([0x80 | opcode]), length, key, body]);
}

// Opens `/socket` of the server at `place`: {port} or {path}. `opened()` is called when it may speak; `heard(is text,
// payload)` gets each message.
export class WebSocketPeer {
  constructor(place, opened, heard, ended = () => {}) {
    this.opened = opened;
    this.heard = heard;
    this.waiting = Buffer.alloc(0);
    this.open = false;
    this.socket = connect(place.path ? {path: place.path} : {host: '127.0.0.1', port: place.port});
    const host = `127.0.0.1:${place.port ?? 80}`;
    this.socket.on('connect', () => this.socket.write(
      `GET /socket HTTP/1.1\r\nHost: ${host}\r\nOrigin: http://${host}\r\nUpgrade: websocket\r\n` +
      `Connection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: ${randomBytes(16).toString('base64')}\r\n\r\n`));
    this.socket.on('data', (bytes) => this.take(bytes));
    this.socket.on('error', () => {});
    this.socket.on('close', () => ended());
  }

  say(message) {
    this.sayText(JSON.stringify(message));
  }
  sayText(text) {
    this.socket.write(masked(kText, Buffer.from(text)));
  }

  // Reads no more until resume(): what was sent waits in the kernel's buffers.
  stall() {
    this.socket.pause();
  }
  resume() {
    this.socket.resume();
  }
  vanish() {
    this.socket.destroy();
  }

  take(bytes) {
    this.waiting = this.waiting.length === 0 ? bytes : Buffer.concat([this.waiting, bytes]);
    if (!this.open) {
      const end = this.waiting.indexOf('\r\n\r\n');
      if (end < 0) return;
      if (!this.waiting.subarray(0, end).includes('101')) throw new Error(this.waiting.subarray(0, end).toString());
      this.waiting = this.waiting.subarray(end + 4);
      this.open = true;
      this.opened(this);
    }
    for (let frame = this.nextFrame(); frame; frame = this.nextFrame()) {
      if (frame.opcode === kPing) this.socket.write(masked(kPong, frame.payload));
      if (frame.opcode === kClose) this.socket.end();
      if (frame.opcode === kText || frame.opcode === kBinary) this.heard(frame.opcode === kText, frame.payload);
    }
  }

  nextFrame() {
    const bytes = this.waiting;
    if (bytes.length < 2) return null;
    let length = bytes[1] & 0x7f;
    let begin = 2;
    if (length === 126) {
      if (bytes.length < 4) return null;
      length = bytes.readUInt16BE(2);
      begin = 4;
    } else if (length === 127) {
      if (bytes.length < 10) return null;
      length = Number(bytes.readBigUInt64BE(2));
      begin = 10;
    }
    if (bytes.length < begin + length) return null;
    this.waiting = bytes.subarray(begin + length);
    return {opcode: bytes[0] & 0x0f, payload: bytes.subarray(begin, begin + length)};
  }
}
