import assert from 'node:assert/strict';
import {afterEach, beforeEach, test} from 'node:test';
import {Connection, kConnectionParameters, type Hearer} from '../src/connection.js';
import type {Stop} from '../src/protocol.js';

/** A socket whose other end is the test. */
class FakeSocket {
  static readonly OPEN = 1;
  static all: FakeSocket[] = [];
  static get newest(): FakeSocket {
    return FakeSocket.all[FakeSocket.all.length - 1]!;
  }
  readyState = 0;
  binaryType = '';
  sent: {type: string; number?: number}[] = [];
  onopen: () => void = () => {};
  onmessage: (event: {data: string}) => void = () => {};
  onclose: (event: {reason: string}) => void = () => {};

  constructor(readonly url: string) {
    FakeSocket.all.push(this);
  }
  send(text: string): void {
    this.sent.push(JSON.parse(text));
  }
  close(): void {}

  open(): void {
    this.readyState = FakeSocket.OPEN;
    this.onopen();
  }
  say(message: object): void {
    this.onmessage({data: JSON.stringify(message)});
  }
  lose(reason = ''): void {
    this.readyState = 3;
    this.onclose({reason});
  }
  get stops(): number {
    return this.sent.filter((message) => message.type === 'stop').length;
  }
}

const kParameters = {...kConnectionParameters, retry_ms: 1, stop_valid_ms: 150};
const kDeaf: Hearer = {onHello() {}, onUpdate() {}, onPicture() {}, onLife() {}, onStopFate() {}};
const real_interval = globalThis.setInterval;
let running: NodeJS.Timeout[] = [];

function connected(hearer: Hearer = kDeaf): Connection {
  const connection = new Connection('ws://robot/socket', null, hearer, kParameters);
  connection.start();
  FakeSocket.newest.open();
  return connection;
}

function stop(state: Stop['state'], request: string): object {
  return {type: 'update', now: '1', stop: {state, request, devices: []}};
}

const pause = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));

beforeEach(() => {
  FakeSocket.all = [];
  (globalThis as Record<string, unknown>).WebSocket = FakeSocket;
  globalThis.setInterval = ((task: () => void, ms: number) => {
    const timer = real_interval(task, ms);
    running.push(timer);
    return timer;
  }) as typeof setInterval;
});
afterEach(() => {
  for (const timer of running) clearInterval(timer);
  running = [];
  globalThis.setInterval = real_interval;
});

test('Stop goes out at once and is answered by the state that mmi tells', () => {
  const connection = connected();
  assert.equal(connection.stop('by hand'), true);
  assert.equal(FakeSocket.newest.stops, 1);
  assert.equal(connection.stopFate, 'sent');
  FakeSocket.newest.say(stop('requested', '1'));
  assert.equal(connection.stopFate, null);
});

test('what mmi had told of an earlier Stop answers no later one', () => {
  const connection = connected();
  FakeSocket.newest.say(stop('acknowledged', '1'));
  connection.stop('by hand');
  FakeSocket.newest.say(stop('acknowledged', '1'));
  assert.equal(connection.stopFate, 'sent');
  FakeSocket.newest.say(stop('requested', '2'));
  assert.equal(connection.stopFate, null);
});

test('a Stop that a lost socket took is sent again by the next', async () => {
  const connection = connected();
  connection.stop('by hand');
  FakeSocket.newest.lose();
  await pause(20);
  assert.equal(FakeSocket.all.length, 2);
  FakeSocket.newest.open();
  assert.equal(FakeSocket.newest.stops, 1);
  assert.equal(FakeSocket.newest.sent[0]?.type, 'stop');
});

test('a Stop waits for a socket', () => {
  const connection = new Connection('ws://robot/socket', null, kDeaf, kParameters);
  connection.start();
  assert.equal(connection.stop('by hand'), false);
  assert.equal(connection.stopFate, 'waiting');
  FakeSocket.newest.open();
  assert.equal(FakeSocket.newest.stops, 1);
});

test('a Stop that nobody answers has failed, and says so', async () => {
  let told = 0;
  const connection = connected({...kDeaf, onStopFate: () => ++told});
  connection.stop('by hand');
  await pause(400);
  assert.equal(connection.stopFate, 'failed');
  assert.equal(told, 1);
  connection.stop('once more');
  assert.equal(connection.stopFate, 'sent');
});

test('without the token there is Stop and nothing else', async () => {
  const connection = connected();
  FakeSocket.newest.lose('another token');
  await pause(20);
  assert.equal(FakeSocket.all.length, 1);
  connection.stop('by hand');
  FakeSocket.newest.open();
  assert.deepEqual(
    FakeSocket.newest.sent.map((message) => message.type),
    ['stop'],
  );
  assert.equal(connection.stopFate, 'sent');
});

test('an update is taken even where it cannot be drawn', () => {
  const failing = {
    ...kDeaf,
    onUpdate: () => {
      throw new Error('no');
    },
  };
  connected(failing);
  assert.throws(() => FakeSocket.newest.say({type: 'update', number: 7, now: '1'}));
  assert.equal(FakeSocket.newest.sent.at(-1)?.number, 7);
});
