import assert from 'node:assert/strict';
import test from 'node:test';
import {middleOf, moved, panTo, type Lie} from '../src/drawing/pixel_cross.js';

const picture: [number, number] = [640, 480];

test('arrows move the cross by a pixel, with Shift by ten', () => {
  const from = {u: 100, v: 50};
  assert.deepEqual(moved(from, 'ArrowRight', false, picture), {u: 101, v: 50});
  assert.deepEqual(moved(from, 'ArrowLeft', true, picture), {u: 90, v: 50});
  assert.deepEqual(moved(from, 'ArrowUp', true, picture), {u: 100, v: 40});
  assert.deepEqual(moved(from, 'ArrowDown', false, picture), {u: 100, v: 51});
  assert.equal(moved(from, 'a', false, picture), null);
});

test('the cross stays in the picture', () => {
  assert.deepEqual(moved({u: 3, v: 479}, 'ArrowLeft', true, picture), {u: 0, v: 479});
  assert.deepEqual(moved({u: 3, v: 479}, 'ArrowDown', false, picture), {u: 3, v: 479});
});

const whole: Lie = {frame: [400, 260], corner: [26.5, 0], size: [347, 260], picture, zoom: 1, pan: [0, 0]};

test('the cross begins in the middle of what is seen', () => {
  assert.deepEqual(middleOf(whole), {u: 320, v: 240});
  assert.deepEqual(middleOf({...whole, zoom: 4, pan: [1e6, -1e6]}), {u: 0, v: 479});
});

test('a picture that is enlarged follows the cross', () => {
  const close = {...whole, zoom: 8};
  for (const pixel of [
    {u: 0, v: 0},
    {u: 17, v: 400},
    {u: 639, v: 479},
  ]) {
    assert.deepEqual(middleOf({...close, pan: panTo(pixel, close)}), pixel);
  }
});
