import assert from 'node:assert/strict';
import test from 'node:test';
import {kMessageTypes} from 'lcmtypes';
import {parseTypes} from '../lcm_types.mjs';
import {csvOf} from '../src/csv.js';
import {kConditions, kZeroWhileUnknown} from '../src/known_values.js';
import {cellsOf, realText, typeOf} from '../src/value_text.js';
import known_values_of_log_tool from '../../../log-tool/known_values.cpp';

const zero = {x: 0, y: 0, z: 0};
const no_covariance = {xx: 0, xy: 0, xz: 0, yy: 0, yz: 0, zz: 0};
const servo = {
  utime: '7',
  session: '9007199254740993',
  seq: '1',
  frame_session: '1',
  frame_seq: '2',
  frame_utime: '3',
  goal_session: '0',
  goal_id: '0',
  state: 2,
  settled: false,
  error_C: {x: 0.00001, y: -1, z: null},
  covariance: {...no_covariance, xx: 1e-6},
  reason: 'a, "b"\n\u202e',
};
const kServoColumns =
  'log_utime,utime,session,seq,frame_session,frame_seq,frame_utime,goal_session,goal_id,state,settled,' +
  'error_C.x,error_C.y,error_C.z,covariance.xx,covariance.xy,covariance.xz,covariance.yy,covariance.yz,covariance.zz,' +
  'reason';
const texts = (type: string, message: object): Record<string, string> =>
  Object.fromEntries(cellsOf(type, message).map(({path, text}) => [path, text]));

test('a table has the columns, names, numbers and quotes of the export', () => {
  assert.equal(
    csvOf([{at: 5, message: servo}], undefined),
    `${kServoColumns}\n` +
      '5,7,9007199254740993,1,1,2,3,0,0,SERVO,false,1e-05,-1,nan,1e-06,0,0,0,0,0,"a, ""b""\\n\\u202e"\n',
  );
});

test('what is not known stays empty, and keeps its column', () => {
  const blind = {...servo, error_C: zero, covariance: no_covariance, reason: ''};
  assert.equal(
    csvOf([{at: 5, message: blind}], undefined),
    `${kServoColumns}\n5,7,9007199254740993,1,1,2,3,0,0,SERVO,false,,,,,,,,,,\n`,
  );
  const hit = {uid: 'a', read_time_known: false, read_utime: '0', rssi_known: true, rssi: 0};
  const of_hit = texts('RfidTagHit', hit);
  assert.deepEqual([of_hit['read_utime'], of_hit['rssi']], ['', '0']);
  const pose = {x: 0, y: 0, heading: 0};
  assert.equal(texts('BaseGoal', {kind: 0, frame: 0, pose})['pose.x'], '');
  assert.equal(texts('BaseGoal', {kind: 1, frame: 1, pose})['pose.x'], '0');
  assert.equal(texts('BaseGoal', {kind: 1, frame: 1, pose})['frame'], 'ROBOT');
  const deaf = {age: -1, latency_p50: 0, latency_p99: 0};
  assert.deepEqual(Object.values(texts('ChannelStatus', deaf)), ['', '', '']);
});

test('each of a message has its own names and its own unknowns', () => {
  const mark = (status: number) => ({name: 'm', role: 1, status, cue: 3, p_C: {x: 1, y: 2, z: 3}});
  const of = texts('TargetPose', {marks: [mark(0), mark(1)]});
  assert.equal(of['marks[0].status'], 'LOCATED');
  assert.equal(of['marks[0].role'], 'ROLE_MANIPULATOR');
  assert.equal(of['marks[0].cue'], 'CUE_CENTROID');
  assert.equal(of['marks[0].p_C.x'], '1');
  assert.equal(of['marks[1].status'], 'UNSEEN');
  assert.equal(of['marks[1].p_C.x'], '');
});

test('messages of different lengths share the columns', () => {
  const state = (position: number[]) => ({...emptyOf('JointState'), num_joints: position.length, position});
  const [head, ...rows] = csvOf(
    [
      {at: 1, message: state([0.5])},
      {at: 2, message: state([1, 2])},
    ],
    undefined,
  ).split('\n');
  const column = head!.split(',').indexOf('position[1]');
  assert.deepEqual(
    rows.slice(0, 2).map((row) => row.split(',')[column]),
    ['', '2'],
  );
  assert.equal(csvOf([], undefined), 'log_utime\n');
});

test('bytes are told by their number, whether mmi sent them or not', () => {
  const patch = {scale: 1, bgr_size: 3, bgr: 'AAAA', mask_size: 9000, mask: {bytes: 9000}};
  const of = texts('MarkPatch', patch);
  assert.deepEqual([of['bgr'], of['mask']], ['3 bytes', '9000 bytes']);
  assert.equal(texts('MarkPatch', {...patch, bgr: 'AA=='})['bgr'], '1 bytes');
});

test('a number with a fraction is the shortest that reads back, as to_chars writes it', () => {
  const written: [number, string][] = [
    [0, '0'],
    [-0, '-0'],
    [2, '2'],
    [0.1, '0.1'],
    [-12.5, '-12.5'],
    [0.001, '0.001'],
    [0.0001, '1e-04'],
    [0.00012, '0.00012'],
    [0.000012, '1.2e-05'],
    [1234567, '1234567'],
    [10000, '10000'],
    [100000, '1e+05'],
    [120000, '120000'],
    [1e21, '1e+21'],
    [1.5e-10, '1.5e-10'],
    [5e-324, '5e-324'],
    [0.30000000000000004, '0.30000000000000004'],
    [1600000000123456, '1600000000123456'],
  ];
  for (const [number, text] of written) assert.equal(realText(number), text);
  // Whole numbers that a type counts with have no exponent, however round.
  assert.equal(texts('RecorderStatus', {parts: 100000})['parts'], '100000');
});

/** A message of the type as mmi would send it, with nothing in it. */
function emptyOf(type: string): Record<string, unknown> {
  return Object.fromEntries(
    kMessageTypes[type]!.map(({name, kind}) => {
      const number = /^num_|_size$/.test(name);
      const is_list = kMessageTypes[type]!.some((one) => one.name === `num_${name}`);
      if (kind in kMessageTypes) return [name, is_list ? [] : emptyOf(kind)];
      if (kind === 'string') return [name, ''];
      if (kind === 'boolean') return [name, false];
      if (kind === 'byte') return [name, ''];
      return [name, kind === 'int64_t' && !number ? '0' : 0];
    }),
  );
}

test('the type of a message is told by its fields', () => {
  const types = ['ServoStatus', 'ServoGoal', 'BaseGoal', 'RobotPose', 'RecorderStatus', 'ProcessStatus', 'TaskState'];
  for (const type of types) assert.equal(typeOf(emptyOf(type)), type);
  const mark = emptyOf('LocatedMark');
  assert.equal(typeOf({...emptyOf('TargetPose'), marks: [mark]}), 'TargetPose');
  assert.equal(typeOf({...emptyOf('StereoMatches'), marks: [emptyOf('MarkMatches')]}), 'StereoMatches');
});

test("a message of another system's type is written as it came", () => {
  const rows = [
    {at: 1, message: {utime: '7', state: 1, reason: 'a, "b"'}},
    {at: 2, message: {utime: '8', state: 0, reason: '', more: 3}},
  ];
  assert.equal(
    csvOf(rows, ['HOLD', 'SERVO']),
    'log_utime,utime,state,reason,more\n1,7,SERVO,"a, ""b""",\n2,8,HOLD,,3\n',
  );
});

test('constants name the fields of one byte in their order, a new row beginning with each 0', () => {
  const {Drive} = parseTypes(`package rover; // struct
    struct Drive { const int8_t OFF = 0, ON = 1; const int8_t NEAR = 0; const int8_t ODD = 7;
      int32_t speed[2]; int8_t list[2]; int8_t mode; int8_t range; int8_t more; }`);
  assert.deepEqual(Drive, [
    {name: 'speed', kind: 'int32_t'},
    {name: 'list', kind: 'int8_t'},
    {name: 'mode', kind: 'int8_t', names: ['OFF', 'ON']},
    {name: 'range', kind: 'int8_t', names: ['NEAR']},
    {name: 'more', kind: 'int8_t'},
  ]);
  assert.equal(kMessageTypes['TaskState']!.find((field) => field.name === 'result')!.names![1], 'RESULT_LIFTED');
});

test('what is known only sometimes is what log-tool holds for that', () => {
  const texts_in = (text: string): string[] => [...text.matchAll(/"([^"]*)"/g)].map((found) => found[1]!);
  const between = (begin: string): string => {
    const from = known_values_of_log_tool.indexOf(begin);
    return known_values_of_log_tool.slice(from, known_values_of_log_tool.indexOf('\n  };', from));
  };
  const conditions = [...between('std::vector<Condition> all').matchAll(/\{\s*("[^{]*)\{([^}]*)\}(, true)?\s*\}/g)].map(
    ([, head, values, unless]) => {
      const [type, field, value] = texts_in(head!);
      return {type, field, value, values: texts_in(values!), unless: unless !== undefined};
    },
  );
  assert.deepEqual(
    conditions,
    kConditions.map((condition) => ({...condition, unless: condition.unless ?? false})),
  );
  const zeros = [...between('std::vector<ZeroWhileUnknown> all').matchAll(/\{"(\w+)", \{([^}]*)\}\}/g)].map(
    ([, type, values]) => ({type, values: texts_in(values!)}),
  );
  assert.deepEqual(zeros, [...kZeroWhileUnknown]);
  for (const {type, values} of [...kConditions, ...kZeroWhileUnknown]) {
    const names = kMessageTypes[type]!.map((field) => field.name);
    for (const value of values) assert.ok(names.includes(value), `${type}.${value}`);
  }
});
