import assert from 'node:assert/strict';
import test from 'node:test';
import {readAddress, writeAddress} from '../src/address.js';
import * as format from '../src/format.js';
import {GoalAnchors} from '../src/goal_anchor.js';
import {Moment, slotId} from '../src/moment.js';
import {keyOf} from '../src/keys.js';
import {isPlottable, leafAt, leaves} from '../src/leaves.js';
import {parsePicture} from '../src/protocol.js';
import {recorderRows} from '../src/recorders.js';
import {joinServices} from '../src/services.js';
import {withoutPatches} from '../src/slim.js';
import {arrivalOf, TagMemory} from '../src/tag_memory.js';
import {phasesPassed, sinceOf} from '../src/task_time.js';
import type {RobotEvent, Slot} from '../src/protocol.js';
import {noneWords, recordingWords} from '../src/words.js';

const key = (name: string, more = {}) => ({key: name, ctrlKey: false, altKey: false, metaKey: false, ...more});
const taskEvent = (number: number, at: number, state: string): RobotEvent => ({
  number,
  at,
  channel: 'TASK_STATE',
  key: '',
  kind: 'task',
  state,
  text: '',
  level: 'info',
});

test('numbers carry their units, and what is not known is a dash', () => {
  assert.equal(format.millimetres(0.00123), '1.2 mm');
  assert.equal(format.metres(1.23456), '1.235 m');
  assert.equal(format.degrees(Math.PI / 2), '90.0°');
  assert.equal(format.hertz(84.2), '84 Hz');
  assert.equal(format.bytes('319000000'), '319 MB');
  assert.equal(format.bytes(1500), '1.5 KB');
  for (const missing of [null, undefined, NaN, Infinity]) assert.equal(format.millimetres(missing), '–');
});

test('spans of time read well from milliseconds to days', () => {
  assert.deepEqual([0.085, 0.5, 9.99, 12.34, 125, 7265, 200000].map(format.span), [
    '85 ms',
    '0.50 s',
    '9.99 s',
    '12.3 s',
    '2 min 05 s',
    '2 h 01 min',
    '2 d 7 h',
  ]);
});

test('the clock takes 64-bit integers as text', () => {
  assert.equal(format.clock('1600000000123456'), '12:26:40.123');
  assert.equal(format.clock('nonsense'), '–');
});

test('Escape stops whatever has the focus, S only where nothing is typed', () => {
  assert.equal(keyOf(key('Escape'), true), 'stop');
  assert.equal(keyOf(key('s'), false), 'stop');
  assert.equal(keyOf(key('S'), false), 'stop');
  assert.equal(keyOf(key('s'), true), null);
  assert.equal(keyOf(key('s', {ctrlKey: true}), false), null);
});

test("a message's leaves are named as the export names its columns", () => {
  const message = {utime: '5', error_C: {x: 1, y: 2}, position: [0.1, 0.2], mask: {bytes: 9000}, marks: []};
  assert.deepEqual(
    leaves(message).map((leaf) => leaf.path),
    ['utime', 'error_C.x', 'error_C.y', 'position[0]', 'position[1]', 'mask'],
  );
  assert.equal(leafAt(message, 'position[1]'), 0.2);
  assert.equal(leafAt(message, 'error_C.x'), 1);
  assert.equal(leafAt(message, 'no.such[3].field'), undefined);
  assert.ok(isPlottable({path: 'settled', value: true}));
  assert.ok(!isPlottable({path: 'session', value: '12345678901234567'}));
});

test('the address keeps view, choice and time, and drops nonsense', () => {
  const address = {view: 'drive', selected: 'E004&x', at: '1600000000000000', token: 'secret'};
  assert.deepEqual(readAddress(writeAddress(address)), address);
  assert.equal(readAddress('#at=12abc').at, null);
});

test('the time in a phase begins with the event that led to it', () => {
  const events = [taskEvent(1, 10, 'IDLE'), taskEvent(2, 20, 'LOOK'), taskEvent(3, 30, 'SERVO')];
  assert.equal(sinceOf(events, 'SERVO'), 30);
  assert.equal(sinceOf(events, 'GRIP'), null);
  assert.deepEqual(phasesPassed([taskEvent(0, 1, 'DONE'), ...events]), ['IDLE', 'LOOK', 'SERVO']);
});

test('a picture is taken apart, and one that is cut off is refused', () => {
  const header = new TextEncoder().encode(JSON.stringify({left_size: 2, right_size: 1}));
  const bytes = new Uint8Array(4 + header.length + 3);
  new DataView(bytes.buffer).setUint32(0, header.length, true);
  bytes.set(header, 4);
  bytes.set([1, 2, 3], 4 + header.length);
  const {left, right} = parsePicture(bytes.buffer);
  assert.deepEqual([...left, ...right], [1, 2, 3]);
  assert.throws(() => parsePicture(bytes.buffer.slice(0, bytes.length - 1)), RangeError);
  assert.throws(() => parsePicture(new ArrayBuffer(2)), RangeError);
});

test('detections are kept without their pixels', () => {
  const slot = {
    channel: 'MARK_DETECTION',
    key: '',
    at: 1,
    message: {marks: [{name: 'hand', left: {u: 1, patch: {bgr: 'AAAA'}}, right: {u: 2, patch: {bgr: 'AAAA'}}}]},
  };
  const text = JSON.stringify(withoutPatches(slot));
  assert.ok(!text.includes('AAAA') && text.includes('"u":1') && text.includes('"bgr":{"bytes":3}'));
});

const goalInRobot = {session: '1', goal_id: '1', kind: 1, frame: 1, pose: {x: 1, y: 0, heading: 0}};
const robotAt = (x: number) => ({x, y: 0, heading: 0});

test("a goal in the robot's frame stays where it was when it was first heard", () => {
  const anchors = new GoalAnchors();
  const second = {...goalInRobot, goal_id: '2'};
  anchors.advance(0);
  anchors.observe(goalInRobot, 2e6, robotAt(0));
  anchors.observe(goalInRobot, 3e6, robotAt(5));
  assert.equal(anchors.goal(goalInRobot)!.x, 1);
  anchors.observe(second, 4e6, robotAt(5));
  assert.equal(anchors.goal(second)!.x, 6);
  assert.equal(anchors.goal(goalInRobot)!.x, 1);
  assert.equal(anchors.goal({...goalInRobot, kind: 0}), null);
});

test("a goal in the robot's frame that was given before we heard the source has no place", () => {
  const anchors = new GoalAnchors();
  anchors.advance(10e6);
  anchors.observe(goalInRobot, 10.1e6, robotAt(3));
  assert.equal(anchors.goal(goalInRobot), null);
  assert.ok(anchors.isUnplaced(goalInRobot));
  assert.ok(!anchors.isUnplaced({...goalInRobot, frame: 0}));
  const next = {...goalInRobot, goal_id: '2'};
  anchors.observe(next, 10.2e6, robotAt(3));
  assert.equal(anchors.goal(next)!.x, 4);
});

test('a place that is known is kept when the source goes on elsewhere, and until all is void', () => {
  const anchors = new GoalAnchors();
  anchors.advance(0);
  anchors.observe(goalInRobot, 2e6, robotAt(0));
  anchors.interrupt();
  anchors.advance(50e6);
  anchors.observe(goalInRobot, 50e6, robotAt(9));
  assert.equal(anchors.goal(goalInRobot)!.x, 1);
  anchors.forget();
  assert.equal(anchors.goal(goalInRobot), null);
});

test('services that died, are silent or wait stand first', () => {
  const service = (name: string, at: number, reason = '') => ({
    channel: 'SERVICE_STATUS',
    key: `${name}@h`,
    at,
    message: {name, state: reason ? 'waiting' : 'ready', reason, pid: 1},
  });
  const process = (name: string, state: number) => ({
    channel: 'PROCESS_STATUS',
    key: `${name}@h`,
    at: 9e6,
    message: {name, state, pid: 1, start_utime: name === 'd' ? '7000000' : '0', restarts: 0, why: ''},
  });
  const rows = joinServices(
    [service('a', 9e6), service('b', 9e6, 'no frames'), service('c', 1e6)],
    [process('d', 6)],
    (state) => ['STOPPED', 'STARTING', 'RUNNING', 'SILENT', 'WAITING', 'ENDED', 'FAILED'][Number(state)]!,
    10e6,
  );
  assert.deepEqual(
    rows.map((row) => `${row.name} ${row.level}`),
    ['c bad', 'd bad', 'b warning', 'a good'],
  );
  assert.equal(rows[1]!.started, 7e6);
  assert.equal(rows[0]!.started, null);
});

test('a recorder tells where it writes, how much, how much is free, in how many parts, and why not', () => {
  const slot = (key: string, at: number, more: object): Slot => ({
    channel: 'RECORDER_STATUS',
    key,
    at,
    message: {folder: '/logs/a', host: 'h', recording: true, bytes: '5', free_bytes: '7', parts: 2, why: '', ...more},
  });
  const rows = recorderRows(
    [
      slot('ended', 9e6, {recording: false, why: 'the disk is full'}),
      slot('well', 9e6, {}),
      slot('mute', 1e6, {}),
      {channel: 'RECORDER_STATUS', key: '', at: 9e6, bad: 'cut off'},
    ],
    9e6,
  );
  assert.deepEqual(
    rows.map((row) => `${row.key} ${row.words} ${row.level} ${row.why}`),
    [
      'RECORDER_STATUS garbled bad not a message: cut off',
      'mute silent bad ',
      'ended not recording warning the disk is full',
      'well recording good ',
    ],
  );
  const {folder, host, bytes, free_bytes, parts} = rows[3]!;
  assert.deepEqual([folder, host, bytes, free_bytes, parts], ['/logs/a', 'h', 5, 7, 2]);
});

test('the tag table remembers the last word of each tag', () => {
  const memory = new TagMemory();
  const tags = [
    {uid: 'a', place: [0, 0] as [number, number]},
    {uid: 'b', place: [1, 0] as [number, number]},
  ];
  memory.observe(
    {
      utime: 1,
      expected: ['a', 'b'],
      missed: ['b'],
      unexpected: [],
      read: [{uid: 'a', rssi: -50, at: 1, count: 1, place: [0, 0]}],
    },
    tags,
    1,
  );
  memory.observe({utime: 2, expected: [], missed: [], unexpected: [], read: []}, tags, 2);
  assert.deepEqual(
    memory.rows(5).map((row) => `${row.uid} ${row.state} ${row.count}`),
    ['a idle 1', 'b idle 0'],
  );
  memory.observe({utime: 0, expected: [], missed: [], unexpected: [], read: []}, tags, 0);
  assert.equal(memory.rows(5).length, 0);
});

test("a tag's age is told by arrivals, whatever clock its reader has", () => {
  const memory = new TagMemory();
  const day_us = 86400e6;
  const read = [{uid: 'a', rssi: null, at: 5, count: 1, place: null}];
  const floor = {utime: '5', expected: [], missed: [], unexpected: [], read};
  const slot = {channel: 'RFID_TAG_HITS', key: '', at: String(2269 * day_us), message: {utime: '5'}};
  const now = 2269 * day_us + 2e6;
  memory.observe(floor, [], arrivalOf(floor, slot, now));
  assert.equal(now - memory.rows(now)[0]!.at, 2e6);
  assert.equal(arrivalOf(floor, {...slot, message: {utime: '6'}}, now), now);
  // Its clock may even be set back while arrivals go on.
  memory.observe({...floor, utime: '1', read: []}, [], now + 1);
  assert.equal(memory.rows(now + 2).length, 1);
});

test('at most 1,000 tags are remembered, those spoken of last', () => {
  const memory = new TagMemory();
  for (let i = 0; i < 1500; i++) {
    memory.observe({utime: i, expected: [`tag ${i}`], missed: [], unexpected: [], read: []}, [], i);
  }
  assert.equal(memory.size, 1000);
  assert.equal(memory.rows(1500)[0]!.uid, 'tag 1499');
});

const momentOf = (now: number, ...slots: Slot[]): Moment => {
  const known = new Map(slots.map((slot) => [slotId(slot.channel, slot.key), slot]));
  return new Moment(
    now,
    (id) => known.get(id),
    () => known.keys(),
  );
};

test('a recorder that is silent while it recorded is told as silent', () => {
  const recorder = (key: string, at: number, recording: boolean): Slot => ({
    channel: 'RECORDER_STATUS',
    key,
    at,
    message: {recording, bytes: 1000, why: ''},
  });
  assert.deepEqual(recordingWords(momentOf(4e6, recorder('a', 0, true))), {on: true, text: 'recording 1.0 KB'});
  assert.equal(recordingWords(momentOf(4.1e6, recorder('a', 0, true))).text, 'recorder silent');
  assert.equal(recordingWords(momentOf(9e6, recorder('a', 0, false))).text, 'not recording');
  assert.equal(recordingWords(momentOf(9e6, recorder('a', 0, true), recorder('b', 1, false))).text, 'not recording');
});

test('a message that is none is told where there would be nothing', () => {
  const bad: Slot = {channel: 'ROBOT_POSE', key: '', at: 1, bad: 'cut off'};
  assert.match(noneWords(momentOf(1, bad), 'ROBOT_POSE'), /not a message: cut off/);
  assert.equal(noneWords(momentOf(1), 'ROBOT_POSE'), 'No ROBOT_POSE yet');
  const rows = joinServices([{channel: 'SERVICE_STATUS', key: '', at: 1, bad: 'cut off'}], [], String, 1);
  assert.deepEqual(
    rows.map((row) => `${row.name} ${row.level} ${row.reason}`),
    ['SERVICE_STATUS bad not a message: cut off'],
  );
});

test("a mark's box in an image is in px, a normal has no unit, and other lengths are m", () => {
  const units = ['marks[0].left.x', 'marks[1].right.patch.width', 'marks[0].normal_C.x', 'pose.x'].map(
    (path) => format.unitOfField(path).unit,
  );
  assert.deepEqual(units, ['px', 'px', '', 'm']);
});
