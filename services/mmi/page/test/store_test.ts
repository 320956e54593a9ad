import assert from 'node:assert/strict';
import test from 'node:test';
import {addSample} from '../src/drawing/samples.js';
import type {Hello, RobotEvent, Update} from '../src/protocol.js';
import {Store} from '../src/store.js';

const hello = (mode: 'live' | 'log', events: RobotEvent[] = [], begin = 0): Hello =>
  ({mode, bus: 'b', log: mode === 'log' ? {begin} : undefined, events}) as unknown as Hello;
const event = (number: number): RobotEvent => ({number, at: String(number)}) as unknown as RobotEvent;
const update = (at: number, more = {}): Update => ({
  type: 'update',
  now: at,
  slots: [{channel: 'A', key: '', at, message: {at}}],
  ...more,
});
const times = (store: Store): number[] => [...store.history.after('A\n', 0)].map((entry) => entry.at);

test('of a log all events are kept, live the newest', () => {
  const events = Array.from({length: 6000}, (_, number) => event(number));
  const store = new Store();
  store.onHello(hello('log', events));
  store.onUpdate(update(2500, {events: [event(6000)]}));
  assert.equal(store.events.length, 6001);
  assert.equal(store.events_shown.length, 2501);
  store.onHello(hello('live', events));
  assert.equal(store.events.length, 5000);
});

test('a seek in a log keeps what has been heard of it, in the order of time and once each', () => {
  const store = new Store();
  store.onHello(hello('log'));
  for (const at of [10, 20, 30]) store.onUpdate(update(at));
  store.onUpdate(update(5, {anew: true}));
  store.onUpdate(update(10));
  assert.deepEqual(times(store), [5, 10, 20, 30]);
  assert.equal(store.seeks, 1);
  store.onHello(hello('log', [], 7));
  assert.deepEqual(times(store), []);
});

test('a time that is shown is a whole number of microseconds, as the address takes it', () => {
  const store = new Store();
  store.pauseAt(1.7);
  assert.equal(store.paused_at, 2);
});

test('samples of earlier times are put where they belong', () => {
  const samples = {at: [10, 30], values: [1, 3] as (number | null)[], generation: 0, number: 0};
  addSample(samples, 20, 2);
  addSample(samples, 5, 0);
  addSample(samples, 30, 4);
  assert.deepEqual(samples.at, [5, 10, 20, 30]);
  assert.deepEqual(samples.values, [0, 1, 2, 4]);
});
