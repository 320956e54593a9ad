import assert from 'node:assert/strict';
import test from 'node:test';
import type {Hello} from '../src/protocol.js';

const sent: {type: string; utime?: string; speed?: number}[] = [];

/** A socket whose other end is the test. */
class FakeSocket {
  static readonly OPEN = 1;
  static newest: FakeSocket;
  readyState = FakeSocket.OPEN;
  onopen = (): void => {};
  onmessage = (_event: {data: string}): void => {};
  onclose = (_event: {reason: string}): void => {};
  constructor() {
    FakeSocket.newest = this;
  }
  send(text: string): void {
    sent.push(JSON.parse(text));
  }
  close(): void {}
  say(message: object): void {
    this.onmessage({data: JSON.stringify(message)});
  }
}

// What a browser has, before the page's one session is made.
Object.assign(globalThis, {
  WebSocket: FakeSocket,
  location: {protocol: 'http:', host: 'robot', hash: ''},
  document: {addEventListener: () => {}, hidden: false},
});
const {start, store} = await import('../src/session.js');
const {goToAddressed, range, shownTime, soughtTime} = await import('../src/transport.js');

const hello = (mode: 'live' | 'log', name: string): Hello =>
  ({
    type: 'hello',
    protocol: 1,
    mode,
    bus: name,
    log: mode === 'log' ? {begin: '100', end: '900'} : undefined,
    channels: [],
    events: [],
  }) as unknown as Hello;
const seeks = (): string[] => sent.filter((message) => message.type === 'seek').map((message) => message.utime!);

test('all goes to a time of a log by the one way that lets one seek be under way', async (context) => {
  // The socket is watched for ever: not by this process.
  const intervals: NodeJS.Timeout[] = [];
  const real_interval = globalThis.setInterval;
  globalThis.setInterval = ((task: () => void, ms: number) => {
    intervals.push(real_interval(task, ms));
    return intervals.at(-1);
  }) as typeof setInterval;
  context.after(() => intervals.forEach((interval) => clearInterval(interval)));
  start();
  globalThis.setInterval = real_interval;

  FakeSocket.newest.onopen();
  FakeSocket.newest.say(hello('log', 'a'));
  for (const at of [300, 400, 500]) goToAddressed(at);
  assert.deepEqual(seeks(), ['300']);
  const play = {utime: '300', playing: false, speed: 1};
  FakeSocket.newest.say({type: 'update', number: 1, now: '300', anew: true, play});
  assert.deepEqual(seeks(), ['300', '500']);
  FakeSocket.newest.say({type: 'update', number: 2, now: '500', anew: true, play: {...play, utime: '500'}});
  assert.equal(soughtTime(), null);
});

test('a log that was lost is gone back to where it was, and plays on', () => {
  const play = {utime: '700', playing: true, speed: 2};
  FakeSocket.newest.say({type: 'update', number: 3, now: '700', play});
  sent.length = 0;
  FakeSocket.newest.say(hello('log', 'a'));
  assert.deepEqual(
    sent.map(({type, utime, speed}) => [type, utime ?? speed]),
    [
      ['seek', '700'],
      ['play', 2],
    ],
  );
  FakeSocket.newest.say({type: 'update', number: 4, now: '100', play: {utime: '100', playing: false, speed: 1}});
  FakeSocket.newest.say({type: 'update', number: 5, now: '700', anew: true, play});
  assert.deepEqual(seeks(), ['700']);
  sent.length = 0;
  FakeSocket.newest.say(hello('log', 'another'));
  assert.deepEqual(seeks(), []);
});

test('live an address of a time that is kept is paused at, one of another time is not', () => {
  FakeSocket.newest.say(hello('live', 'b'));
  goToAddressed(50);
  assert.equal(store.paused_at, null);
  assert.notEqual(store.notice, '');
  FakeSocket.newest.say({type: 'update', number: 6, now: '1000', slots: []});
  FakeSocket.newest.say({type: 'update', number: 7, now: '2000', slots: []});
  assert.deepEqual(range(), {begin: 1000, end: 2000});
  goToAddressed(1500);
  assert.equal(shownTime(), 1500);
  assert.equal(store.notice, '');
});
