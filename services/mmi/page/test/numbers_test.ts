import assert from 'node:assert/strict';
import test from 'node:test';
import {ellipseOf} from '../src/drawing/geometry.js';
import {millimetres} from '../src/format.js';
import {GoalAnchors} from '../src/goal_anchor.js';
import {finitePoint, finitePose, numberOf, words} from '../src/numbers.js';

test('a null of a message is no number, and never 0', () => {
  for (const none of [null, undefined, NaN, Infinity, 'x']) assert.ok(Number.isNaN(numberOf(none)));
  assert.equal(numberOf(0), 0);
  assert.equal(words(null, millimetres), 'not a number');
  assert.equal(words(0.001, (value) => millimetres(value)), '1.0 mm');
});

test('poses and points are drawn only where all their numbers are finite', () => {
  const pose = {x: 1, y: 2, heading: 0};
  assert.equal(finitePose(pose), pose);
  assert.equal(finitePose({...pose, x: null as unknown as number}), null);
  assert.equal(finitePoint([1, 2, null as unknown as number]), null);
  assert.deepEqual(finitePoint([1, 2, 3]), [1, 2, 3]);
});

test('a covariance with a null has no size, rather than one of 0', () => {
  assert.ok(Number.isNaN(ellipseOf(null, 0, 1).a));
});

test("a goal with a null is nowhere, in the robot's frame too", () => {
  const pose = {x: null, y: 0, heading: 0};
  const robot = {x: 1, y: 1, heading: 0};
  for (const frame of [0, 1]) {
    const anchors = new GoalAnchors();
    const message = {session: '1', goal_id: '1', kind: 1, frame, pose};
    anchors.advance(0);
    anchors.observe(message, 2e6, robot);
    assert.equal(anchors.goal(message), null);
  }
});
