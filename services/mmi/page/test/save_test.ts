import assert from 'node:assert/strict';
import test from 'node:test';
import {paintOnGround, type Painter} from '../src/save.js';

test("a drawing is saved on the theme's ground: all of it is filled first", () => {
  const done: unknown[] = [];
  const painter = {
    fillStyle: '',
    fillRect: (...box: number[]) => done.push([painter.fillStyle, ...box]),
    drawImage: (...image: unknown[]) => done.push(image),
  };
  const drawing = {width: 600, height: 200} as HTMLCanvasElement;
  paintOnGround(painter as unknown as Painter, drawing, '#1a2125');
  assert.deepEqual(done, [
    ['#1a2125', 0, 0, 600, 200],
    [drawing, 0, 0],
  ]);
});
