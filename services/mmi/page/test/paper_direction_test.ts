import assert from 'node:assert/strict';
import test from 'node:test';
import {FloorScale} from '../src/drawing/floor_map.js';
import {directionArrow} from '../src/drawing/paper_direction.js';

const scale = new FloorScale(100, [0, 0], [200, 200]);
const paper = {
  measured_known: true,
  compensated_x: 0.5,
  compensated_y: 0.2,
  direction_known: true,
  direction: Math.PI / 2,
  speed: 0.4,
};
const endsOf = (path: string): number[] => /^M(\S+) (\S+)L([-\d.]+) ([-\d.]+)/.exec(path)!.slice(1).map(Number);

test("the paper's direction of motion is an arrow from its compensated place, W's y up, told in words", () => {
  const arrow = directionArrow(scale, paper)!;
  assert.deepEqual(endsOf(arrow.path), [150, 80, 150, 28]);
  assert.ok(arrow.words_at[1] < 28);
  assert.equal(arrow.words, 'moves at 90.0°, 0.40 m/s');
  const back = directionArrow(scale, {...paper, direction: Math.PI})!;
  assert.deepEqual(endsOf(back.path), [150, 80, 98, 80]);
});

test('the words lie beside the arrow, wherever it points', () => {
  const anchorOf = (direction: number): string => directionArrow(scale, {...paper, direction})!.anchor;
  assert.deepEqual([0, Math.PI / 2, Math.PI, -Math.PI / 2].map(anchorOf), ['start', 'middle', 'end', 'middle']);
});

test('there is no arrow where no direction is known or one of its numbers is none', () => {
  const none = null as unknown as number;
  assert.equal(directionArrow(scale, undefined), null);
  assert.equal(directionArrow(scale, {...paper, direction_known: false}), null);
  assert.equal(directionArrow(scale, {...paper, measured_known: false}), null);
  assert.equal(directionArrow(scale, {...paper, direction: none}), null);
  assert.equal(directionArrow(scale, {...paper, compensated_x: none}), null);
  assert.match(directionArrow(scale, {...paper, speed: none})!.words, /speed not a number/);
});
