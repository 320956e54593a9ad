import assert from 'node:assert/strict';
import test from 'node:test';
import {Seeker} from '../src/seeker.js';

test('one seek is under way at a time, and then only the newest wanted is made', () => {
  const sent: number[] = [];
  const seeker = new Seeker((at) => sent.push(at));
  for (const at of [1, 2, 3, 4]) seeker.seek(at, 0);
  assert.deepEqual(sent, [1]);
  assert.equal(seeker.target, 4);
  seeker.arrived(100);
  assert.deepEqual(sent, [1, 4]);
  seeker.arrived(200);
  assert.equal(seeker.target, null);
  assert.deepEqual(sent, [1, 4]);
});

test('what is forgotten is sought no more', () => {
  const sent: number[] = [];
  const seeker = new Seeker((at) => sent.push(at));
  seeker.seek(1, 0);
  seeker.seek(2, 0);
  seeker.forget();
  assert.equal(seeker.target, null);
  seeker.seek(3, 1);
  assert.deepEqual(sent, [1, 3]);
});

test('a seek that brings nothing does not hold up the next for ever', () => {
  const sent: number[] = [];
  const seeker = new Seeker((at) => sent.push(at));
  seeker.seek(1, 0);
  seeker.work(900);
  assert.equal(seeker.target, 1);
  seeker.work(1100);
  assert.equal(seeker.target, null);
  seeker.seek(2, 1200);
  assert.deepEqual(sent, [1, 2]);
});
