import assert from 'node:assert/strict';
import test from 'node:test';
import {addSample} from '../src/drawing/samples.js';
import type {Hello, RobotEvent, Update} from '../src/protocol.js';
import {pastWords} from '../src/past_words.js';
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
  assert.equal(store.events_forgotten, 1000);
  store.onUpdate(update(2600, {events: [event(6000)]}));
  assert.equal(store.events_forgotten, 1001);
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

const second = 1e6;

test('a time of before the page was opened is not kept: the newest is shown, and it is said', () => {
  const store = new Store();
  store.onHello(hello('live'));
  store.recall(50 * second);
  assert.equal(store.paused_at, null);
  assert.match(pastWords(store)!, /^00:00:50 UTC is not kept by this page: the newest is shown/);
  // The last word of a rare channel is older than what the page knows of the others.
  store.onUpdate(update(100 * second, {slots: [{channel: 'RARE', key: '', at: 40 * second, message: {}}]}));
  assert.equal(store.kept_begin, 100 * second);
  store.recall(50 * second);
  assert.equal(store.paused_at, null);
  store.pauseAt(null);
  assert.equal(pastWords(store), null);
  store.recall(100 * second);
  assert.equal(store.paused_at, 100 * second);
  assert.equal(pastWords(store), 'PAST · key L for live');
});

test('of a pause that is no longer kept the oldest that is kept is shown, and it is said', () => {
  const store = new Store();
  store.onHello(hello('live'));
  for (let at = 0; at <= 100; at += 10) store.onUpdate(update(at * second));
  store.pauseAt(20 * second);
  assert.equal(store.moment.message('A').at, 20 * second);
  for (let at = 110; at <= 400; at += 10) store.onUpdate(update(at * second));
  assert.ok(store.past_is_lost);
  assert.equal(store.shown_past, 100 * second);
  assert.equal(store.moment.now, 100 * second);
  assert.equal(store.moment.message('A').at, 100 * second);
  assert.match(pastWords(store)!, /00:00:20 is no longer kept: the oldest that is, 00:01:40 UTC, is shown/);
  assert.equal(store.paused_at, 20 * second);
});

test('where the source begins anew a pause ends, and it is said', () => {
  const store = new Store();
  store.onHello(hello('live'));
  store.onUpdate(update(20 * second));
  store.pauseAt(20 * second);
  store.onUpdate(update(5 * second, {anew: true}));
  assert.equal(store.paused_at, null);
  assert.match(pastWords(store)!, /began anew/);
  assert.equal(store.kept_begin, 5 * second);
});

test('where a log was left is told once, when that log is there again', () => {
  const play = {utime: '70', playing: true, speed: 2};
  const store = new Store();
  store.onHello(hello('log'));
  store.onUpdate(update(70, {play}));
  assert.equal(store.takeLeft(), null);
  store.onHello(hello('log'));
  store.onUpdate(update(0, {play: {utime: '0', playing: false, speed: 1}}));
  assert.deepEqual(store.takeLeft(), play);
  assert.equal(store.takeLeft(), null);
  store.onHello(hello('log', [], 7));
  assert.equal(store.takeLeft(), null);
});

test("a goal in the robot's frame has its place from when it came, whoever looks at it and when", () => {
  const of = (x: number) => ({pose: {x, y: 0, heading: 0}});
  const pose = (at: number, x: number) => ({channel: 'ROBOT_POSE', key: '', at, message: of(x)});
  const goal = {session: '1', goal_id: '1', kind: 1, frame: 1, pose: {x: 1, y: 0, heading: 0}};
  const slotOfGoal = (at: number) => ({channel: 'BASE_GOAL', key: '', at, message: goal});
  const store = new Store();
  store.onHello(hello('live'));
  store.onUpdate(update(0, {slots: [pose(0, 0)]}));
  store.onUpdate(update(5 * second, {slots: [pose(5 * second, 2)]}));
  // The goal comes first in the update, and was heard before the pose that comes with it.
  store.onUpdate(update(5.1 * second, {slots: [slotOfGoal(5.05 * second), pose(5.1 * second, 3)]}));
  store.onUpdate(update(9 * second, {slots: [slotOfGoal(9 * second), pose(9 * second, 7)]}));
  assert.equal(store.goals.goal(store.moment.message('BASE_GOAL'))!.x, 3);
});

test("a goal is not placed by a robot's pose of another time", () => {
  const store = new Store();
  const goal = {session: '1', goal_id: '1', kind: 1, frame: 1, pose: {x: 1, y: 0, heading: 0}};
  store.onHello(hello('live'));
  const robot = {pose: {x: 0, y: 0, heading: 0}};
  store.onUpdate(update(0, {slots: [{channel: 'ROBOT_POSE', key: '', at: 0, message: robot}]}));
  store.onUpdate(update(9e6, {slots: [{channel: 'BASE_GOAL', key: '', at: 9e6, message: goal}]}));
  assert.equal(store.goals.goal(goal), null);
});

test('samples of earlier times are put where they belong', () => {
  const samples = {at: [10, 30], values: [1, 3] as (number | null)[], generation: 0, number: 0};
  addSample(samples, 20, 2);
  addSample(samples, 5, 0);
  addSample(samples, 30, 4);
  assert.deepEqual(samples.at, [5, 10, 20, 30]);
  assert.deepEqual(samples.values, [0, 1, 2, 4]);
});
