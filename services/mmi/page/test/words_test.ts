import assert from 'node:assert/strict';
import test from 'node:test';
import {readAddress, writeAddress} from '../src/address.js';
import {csvOf} from '../src/csv.js';
import * as format from '../src/format.js';
import {GoalAnchor} from '../src/goal_anchor.js';
import {Moment, slotId} from '../src/moment.js';
import {keyOf} from '../src/keys.js';
import {isPlottable, leafAt, leaves} from '../src/leaves.js';
import {parsePicture} from '../src/protocol.js';
import {joinServices} from '../src/services.js';
import {withoutPatches} from '../src/slim.js';
import {TagMemory} from '../src/tag_memory.js';
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

test('a table begins with log_utime, names states, and quotes what needs it', () => {
  const rows = [
    {at: 1, message: {utime: '7', state: 1, reason: 'a, "b"'}},
    {at: 2, message: {utime: '8', state: 0, reason: '', more: 3}},
  ];
  assert.equal(
    csvOf(rows, ['HOLD', 'SERVO']),
    'log_utime,utime,state,reason,more\n1,7,SERVO,"a, ""b""",\n2,8,HOLD,,3\n',
  );
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
  assert.ok(!text.includes('AAAA') && text.includes('"u":1'));
});

test("a goal in the robot's frame stays where it was when it was first heard", () => {
  const anchor = new GoalAnchor();
  const message = {session: '1', goal_id: '1', kind: 1, frame: 1, pose: {x: 1, y: 0, heading: 0}};
  assert.equal(anchor.goal(message, {x: 0, y: 0, heading: 0})!.x, 1);
  assert.equal(anchor.goal(message, {x: 5, y: 0, heading: 0})!.x, 1);
  assert.equal(anchor.goal({...message, goal_id: '2'}, {x: 5, y: 0, heading: 0})!.x, 6);
  assert.equal(anchor.goal({...message, kind: 0}, null), null);
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
    message: {name, state, pid: 1, restarts: 0, why: ''},
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
  );
  memory.observe({utime: 2, expected: [], missed: [], unexpected: [], read: []}, tags);
  assert.deepEqual(
    memory.rows(5).map((row) => `${row.uid} ${row.state} ${row.count}`),
    ['a idle 1', 'b idle 0'],
  );
  memory.observe({utime: 0, expected: [], missed: [], unexpected: [], read: []}, tags);
  assert.equal(memory.rows(5).length, 0);
});

test('at most 1,000 tags are remembered, those spoken of last', () => {
  const memory = new TagMemory();
  for (let i = 0; i < 1500; i++) {
    memory.observe({utime: i, expected: [`tag ${i}`], missed: [], unexpected: [], read: []}, []);
  }
  assert.equal(memory.size, 1000);
  assert.equal(memory.rows(5)[0]!.uid, 'tag 1499');
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
