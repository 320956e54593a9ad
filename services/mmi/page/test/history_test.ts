import assert from 'node:assert/strict';
import test from 'node:test';
import {PictureHistory, TextHistory} from '../src/history.js';

test('the value at a time is the newest at or before it', () => {
  const history = new TextHistory(1e6, 1e9);
  history.add('a', 10, {v: 1});
  history.add('a', 20, {v: 2});
  assert.deepEqual(history.at('a', 20), {v: 2});
  assert.deepEqual(history.at('a', 19), {v: 1});
  assert.equal(history.at('a', 9), undefined);
  assert.equal(history.at('b', 20), undefined);
});

test('the texts never take more than the limit, whatever comes', () => {
  const history = new TextHistory(10000, 1e12);
  for (let i = 0; i < 20000; i++) {
    history.add(`channel ${i % 7}`, i, 'x'.repeat(i % 90));
    assert.ok(history.bytes <= 10000 + 7 * 92, `${history.bytes} bytes after ${i}`);
  }
});

test('what is older than the limit is forgotten, but what held last still holds', () => {
  const history = new TextHistory(1e6, 100);
  history.add('rare', 0, 'first');
  for (let at = 10; at <= 1000; at += 10) history.add('often', at, at);
  assert.equal(history.begin, 900);
  assert.equal(history.at('rare', 950), 'first');
  assert.equal(history.at('often', 880), undefined);
  assert.equal(history.at('often', 955), 950);
});

test('all values between two times come in order', () => {
  const history = new TextHistory(1e6, 1e9);
  for (let at = 0; at < 3000; at++) history.add('a', at, at);
  assert.deepEqual(
    [...history.between('a', 1500, 1502)].map((entry) => entry.value),
    [1500, 1501, 1502],
  );
});

test('forgetting gives all bytes back', () => {
  const history = new TextHistory(1e6, 1e9);
  history.add('a', 1, 'text');
  history.forget();
  assert.equal(history.bytes, 0);
  assert.equal(history.begin, null);
});

test('pictures are bounded by bytes and by age, and the newest always stays', () => {
  const pictures = new PictureHistory(1000, 50);
  for (let at = 0; at < 100; at++) pictures.add(at, new ArrayBuffer(100));
  assert.equal(pictures.size, 10);
  assert.equal(pictures.bytes, 1000);
  pictures.add(500, new ArrayBuffer(10));
  assert.equal(pictures.size, 1);
  pictures.add(501, new ArrayBuffer(5000));
  assert.equal(pictures.size, 1);
});

test('stepping goes from picture to picture and stops at the ends', () => {
  const pictures = new PictureHistory(1e6, 1e6);
  for (const at of [10, 20, 30]) pictures.add(at, new ArrayBuffer(1));
  assert.equal(pictures.step(25, 1), 30);
  assert.equal(pictures.step(25, -1), 10);
  assert.equal(pictures.step(10, -1), null);
  assert.equal(pictures.step(30, 1), null);
});

test('the same picture with more known of it takes the place of the first', () => {
  const pictures = new PictureHistory(1e6, 1e6);
  pictures.add(10, new ArrayBuffer(1));
  pictures.add(20, new ArrayBuffer(1));
  pictures.add(20, new ArrayBuffer(3));
  assert.equal(pictures.size, 2);
  assert.equal(pictures.bytes, 4);
  assert.equal(pictures.step(20, -1), 10);
});
