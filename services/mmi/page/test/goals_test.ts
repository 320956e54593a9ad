import assert from 'node:assert/strict';
import test from 'node:test';
import {goalsOf} from '../src/drawing/goals_3d.js';
import type {Covariance6, Places, Point} from '../src/protocol.js';

const mark = (name: string, role: string, p_R: Point | null, covariance_R: Covariance6 | null) => ({
  name,
  role,
  status: 'LOCATED',
  cue: 'TEXTURE',
  p_R,
  covariance_R,
  normal_R: null,
});
const of_book: Covariance6 = [1, 2, 3, 4, 5, 6];
const places: Places = {
  utime: '1',
  frame_seq: '7',
  marks: [mark('book', 'target', [1, 0, 0], of_book), mark('hand', 'manipulator', [0.5, 0.1, 0.2], of_book)],
  grip_goal_R: [0.9, 0, 0.1],
};
const goal = {target: 'book'};
// In C: x right, y forward, z up.
const status = {
  frame_seq: '7',
  error_C: {x: 0.01, y: 0.02, z: 0.03},
  covariance: {xx: 1, xy: 2, xz: 3, yy: 4, yz: 5, zz: 6},
};

test("the grip point's goal is as uncertain as its target", () => {
  const [grip] = goalsOf(places, goal, null);
  assert.deepEqual(grip, {what: 'grip', p_R: [0.9, 0, 0.1], covariance_R: of_book, mark: null});
  assert.equal(goalsOf(places, {target: 'other'}, null)[0]!.covariance_R, null);
});

test("the hand's goal is its mark moved by the measured error, turned from C into R", () => {
  const hand = goalsOf(places, goal, status)[1]!;
  assert.equal(hand.what, 'hand');
  assert.equal(hand.mark!.name, 'hand');
  hand.p_R.forEach((value, k) => assert.ok(Math.abs(value - [0.48, 0.11, 0.17][k]!) < 1e-12));
  assert.deepEqual(hand.covariance_R, [4, -2, 5, 1, -3, 6]);
});

test('a goal that is not known is not drawn', () => {
  const only_grip = (more: object, of: Places = places): void => {
    assert.deepEqual(
      goalsOf(of, goal, {...status, ...more}).map((one) => one.what),
      ['grip'],
    );
  };
  only_grip({frame_seq: '6'});
  only_grip({covariance: {xx: 0, xy: 0, xz: 0, yy: 0, yz: 0, zz: 0}});
  only_grip({error_C: {x: null, y: 0, z: NaN}});
  only_grip({}, {...places, marks: [places.marks[0]!]});
  assert.deepEqual(goalsOf({...places, grip_goal_R: null}, goal, status), []);
  assert.deepEqual(goalsOf(null, null, null), []);
});
