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
  closed = false;
  close(): void {
    this.closed = true;
  }

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
const real_now = performance.now.bind(performance);
let running: NodeJS.Timeout[] = [];
let watching: (() => void)[] = [];
let shift_ms = 0;

function connected(hearer: Hearer = kDeaf): Connection {
  const connection = new Connection('ws://robot/socket', null, hearer, kParameters);
  connection.start();
  FakeSocket.newest.open();
  return connection;
}

function stop(state: Stop['state'], request: string): object {
  return {type: 'update', now: '1', stop: {state, request, devices: []}};
}

/** Lets time pass at the connection's clock, without waiting for it. */
function passes(ms: number): void {
  for (let passed = 0; passed < ms; passed += 100) {
    shift_ms += 100;
    for (const watch of watching) watch();
  }
}

const pause = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));

beforeEach(() => {
  FakeSocket.all = [];
  watching = [];
  shift_ms = 0;
  Object.defineProperty(performance, 'now', {value: () => real_now() + shift_ms, configurable: true});
  (globalThis as Record<string, unknown>).WebSocket = FakeSocket;
  globalThis.setInterval = ((task: () => void, ms: number) => {
    const timer = real_interval(task, ms);
    running.push(timer);
    watching.push(task);
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

/** By hand: a socket is opened for it, on which nothing else is said. */
function stopsAlone(connection: Connection): void {
  connection.stop('by hand');
  FakeSocket.newest.open();
  assert.deepEqual(
    FakeSocket.newest.sent.map((message) => message.type),
    ['stop'],
  );
}

test('without the token there is Stop and nothing else', async () => {
  const connection = connected();
  FakeSocket.newest.lose('another token');
  await pause(20);
  assert.equal(FakeSocket.all.length, 1);
  stopsAlone(connection);
  assert.equal(connection.stopFate, 'sent');
});

/** What the page is told of its connection, in order. */
function lives(): {told: string[]; hearer: Hearer} {
  const told: string[] = [];
  return {told, hearer: {...kDeaf, onLife: (life, why) => told.push(why ? `${life}: ${why}` : life)}};
}
const hello = {type: 'hello', protocol: 1, update_at_least_every: 0.25};

test('the page is open once mmi has said hello, and not before', () => {
  const {told, hearer} = lives();
  connected(hearer);
  FakeSocket.newest.say({type: 'update', now: '1'});
  assert.deepEqual(told, []);
  FakeSocket.newest.say(hello);
  assert.deepEqual(told, ['open']);
});

test('a handshake that hangs, and a hello that never comes, are given up and tried again', () => {
  const {told, hearer} = lives();
  const connection = new Connection('ws://robot/socket', null, hearer, kParameters);
  connection.start();
  passes(4000);
  assert.equal(FakeSocket.all.length, 1);
  passes(2000);
  assert.equal(FakeSocket.all.length, 2);
  assert.ok(FakeSocket.all[0]!.closed);
  assert.deepEqual(told, ['lost: no answer within 5 s']);
  // The second time it may take twice as long.
  FakeSocket.newest.open();
  passes(7000);
  assert.equal(FakeSocket.all.length, 2);
  passes(3000);
  assert.equal(FakeSocket.all.length, 3);
  FakeSocket.newest.open();
  FakeSocket.newest.say(hello);
  assert.equal(told.at(-1), 'open');
});

test('a page that slept has not waited all that time for a hello', () => {
  connected();
  shift_ms += 3600e3;
  passes(1000);
  assert.equal(FakeSocket.all.length, 1);
});

test('what a socket says that was given up is not heard', () => {
  const {told, hearer} = lives();
  new Connection('ws://robot/socket', null, hearer, kParameters).start();
  passes(6000);
  FakeSocket.all[0]!.open();
  FakeSocket.all[0]!.say(hello);
  assert.deepEqual(told, ['lost: no answer within 5 s']);
});

test('another protocol than ours is told in words, and leaves Stop', async () => {
  const {told, hearer} = lives();
  let heard = 0;
  const connection = connected({...hearer, onHello: () => ++heard});
  FakeSocket.newest.say({...hello, protocol: 2});
  assert.equal(heard, 0);
  assert.deepEqual(told, ['lost: it speaks protocol 2, this page 1: reload the page']);
  passes(10000);
  await pause(20);
  assert.equal(FakeSocket.all.length, 1);
  stopsAlone(connection);
});

test('where mmi refuses our protocol it is not asked again', async () => {
  const {told, hearer} = lives();
  connected(hearer);
  FakeSocket.newest.lose('another protocol than 2: reload the page');
  await pause(20);
  assert.equal(FakeSocket.all.length, 1);
  assert.deepEqual(told, ['lost: another protocol than 2: reload the page']);
});

test('another token is tried at once, the same one is not', async () => {
  const connection = connected();
  FakeSocket.newest.lose('another token');
  await pause(20);
  assert.equal(FakeSocket.all.length, 1);
  connection.useToken('new');
  assert.equal(FakeSocket.all.length, 2);
  FakeSocket.newest.open();
  assert.deepEqual(FakeSocket.newest.sent[0], {type: 'hello', protocol: 1, token: 'new'});
  connection.useToken('new');
  assert.equal(FakeSocket.all.length, 2);
  connection.useToken('newer');
  assert.ok(FakeSocket.all[1]!.closed);
  assert.equal(FakeSocket.all.length, 3);
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
