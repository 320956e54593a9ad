import assert from 'node:assert/strict';
import test from 'node:test';
import {frustumOf} from '../src/drawing/geometry.js';
import type {CamerasScene} from '../src/protocol.js';

const cameras: CamerasScene = {
  width_px: 640,
  height_px: 480,
  fx_px: 500,
  fy_px: 400,
  cx_left_px: 320,
  cx_right_px: 300,
  cy_px: 240,
  baseline: 0.1,
  p_RC: [0.2, 0.05, 0.9],
};

/** What C's camera sees at a point of R: px. */
function seen(side: 'left' | 'right', lens: readonly number[], point: readonly number[]): [number, number] {
  const [ahead, left, up] = [0, 1, 2].map((axis) => point[axis]! - lens[axis]!) as [number, number, number];
  const cx_px = side === 'left' ? cameras.cx_left_px : cameras.cx_right_px;
  return [cx_px + (cameras.fx_px * -left) / ahead, cameras.cy_px + (cameras.fy_px * -up) / ahead];
}

test("a field of view ends where the image's corners are seen, so far ahead of its lens", () => {
  for (const side of ['left', 'right'] as const) {
    const {lens, corners} = frustumOf(cameras, side, 0.45);
    assert.deepEqual(lens.map((value) => value.toFixed(3)), ['0.200', side === 'left' ? '0.050' : '-0.050', '0.900']);
    const wanted = [
      [0, 0],
      [640, 0],
      [640, 480],
      [0, 480],
    ];
    corners.forEach((corner, index) => {
      assert.ok(Math.abs(corner[0] - lens[0] - 0.45) < 1e-12);
      seen(side, lens, corner).forEach((px, axis) => assert.ok(Math.abs(px - wanted[index]![axis]!) < 1e-9));
    });
  }
});
