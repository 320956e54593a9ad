import assert from 'node:assert/strict';
import test from 'node:test';
import {axesOf, compose, ellipseOf, maskRuns, pathOfRuns, transform} from '../src/drawing/geometry.js';
import {FloorScale, scaleToFit, tagStates} from '../src/drawing/floor_map.js';
import {labelLevels} from '../src/drawing/labels.js';
import {layOut} from '../src/drawing/procedure_layout.js';
import {joinCurves, nearestIndex} from '../src/drawing/samples.js';

const near = (a: number, b: number, tolerance = 1e-9): void =>
  assert.ok(Math.abs(a - b) <= tolerance, `${a} is not ${b}`);

test("an ellipse has the covariance's axes and turns with them", () => {
  const straight = ellipseOf(9, 0, 4);
  near(straight.a, 3);
  near(straight.b, 2);
  near(straight.angle, 0);
  const turned = ellipseOf(5, 3, 5);
  near(turned.a, Math.sqrt(8));
  near(turned.b, Math.sqrt(2));
  near(turned.angle, Math.PI / 4);
});

test('what is no covariance draws nothing rather than NaN', () => {
  assert.equal(ellipseOf(-1, 0, -1).a, 0);
});

test('the axes of a covariance in space give it back', () => {
  const covariance = [4, 1, -0.5, 3, 0.25, 2];
  const {values, vectors} = axesOf(covariance);
  const again = (i: number, j: number): number =>
    values.reduce((sum, value, k) => sum + value * vectors[i]![k]! * vectors[j]![k]!, 0);
  [
    [0, 0],
    [0, 1],
    [0, 2],
    [1, 1],
    [1, 2],
    [2, 2],
  ].forEach(([i, j], index) => near(again(i!, j!), covariance[index]!, 1e-9));
});

test("a goal in the robot's frame is turned and moved with the robot", () => {
  const goal = compose({x: 1, y: 2, heading: Math.PI / 2}, {x: 0.5, y: 0, heading: 0.1});
  near(goal.x, 1);
  near(goal.y, 2.5);
  near(goal.heading, Math.PI / 2 + 0.1);
  near(transform({x: 1, y: 2, heading: Math.PI}, 1, 0)[0], 0);
});

test("a mask's bits become runs at the patch's place and scale", () => {
  // Two rows of 10 pixels, lowest bit first: pixels 1 to 3, and 8 to 9.
  const mask = Buffer.from([0b00001110, 0, 0, 0b00000011]).toString('base64');
  const runs = maskRuns({x: 100, y: 50, scale: 2, width: 10, height: 2, mask});
  assert.deepEqual(runs, [
    [102, 50, 6, 2],
    [116, 52, 4, 2],
  ]);
  assert.equal(pathOfRuns(runs.slice(0, 1)), 'M102 50h6v2h-6z');
});

test('a mask that is missing, too large to be sent or cut off draws nothing', () => {
  assert.deepEqual(maskRuns(null), []);
  assert.deepEqual(maskRuns({x: 0, y: 0, scale: 1, width: 8, height: 8, mask: {bytes: 9000}}), []);
  assert.deepEqual(maskRuns({x: 0, y: 0, scale: 1, width: 8, height: 8, mask: 'AA=='}), []);
  assert.deepEqual(maskRuns({x: 0, y: 0, scale: 0, width: 0, height: 0, mask: ''}), []);
});

test("the floor's y goes up, and all tags are in view", () => {
  const scale = scaleToFit(
    [
      [0, 0],
      [0.4, 1.1],
    ],
    0.1,
    [600, 600],
  );
  const [x0, y0] = scale.at(0, 0);
  const [x1, y1] = scale.at(0.4, 1.1);
  assert.ok(x1 > x0 && y1 < y0);
  for (const value of [x0, y0, x1, y1]) assert.ok(value >= 0 && value <= 600);
  assert.deepEqual(new FloorScale(100, [0, 0], [200, 200]).at(0, 0), [100, 100]);
});

test('a tag that was read where it was not expected is said to be so', () => {
  const read = (uid: string) => ({uid, rssi: null, at: 0, count: 1, place: null});
  const states = tagStates({
    utime: 0,
    expected: ['a', 'b'],
    missed: ['b'],
    read: [read('a'), read('c')],
    unexpected: ['c'],
  });
  assert.deepEqual(Object.fromEntries(states), {a: 'read', b: 'missed', c: 'unexpected'});
  assert.equal(tagStates(null).size, 0);
});

test('labels side by side move away from each other, lone ones stay', () => {
  assert.deepEqual(
    labelLevels([
      {x: 0, y: 0, letters: 8},
      {x: 20, y: 0, letters: 8},
      {x: 500, y: 0, letters: 8},
    ]),
    [0, 1, 0],
  );
});

test('the procedure begins with its first phase, ends stand in the last row, none is left out', () => {
  const phases = ['IDLE', 'SERVO', 'LOOK', 'DONE', 'ALONE'];
  const nodes = layOut(phases, [
    {from: 'IDLE', to: 'LOOK', when: ''},
    {from: 'LOOK', to: 'SERVO', when: ''},
    {from: 'SERVO', to: 'DONE', when: ''},
    {from: 'SERVO', to: 'LOOK', when: ''},
  ]);
  assert.deepEqual(nodes.map((node) => node.phase).sort(), [...phases].sort());
  assert.deepEqual(
    nodes.slice(0, 3).map((node) => node.phase),
    ['IDLE', 'LOOK', 'SERVO'],
  );
  assert.ok(nodes.find((node) => node.phase === 'DONE')!.y > nodes[0]!.y);
});

test('curves share one axis of time', () => {
  const joined = joinCurves(
    [
      {at: [1, 3], values: [10, 30], generation: 0},
      {at: [2, 3], values: [5, null], generation: 0},
    ],
    1,
  );
  assert.deepEqual(joined, [
    [1, 2, 3],
    [10, undefined, 30],
    [undefined, 5, null],
  ]);
  assert.equal(nearestIndex([1, 3], 2), 0);
  assert.equal(nearestIndex([1, 3], 0.5), -1);
});
