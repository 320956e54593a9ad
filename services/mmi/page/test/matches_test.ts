import assert from 'node:assert/strict';
import test from 'node:test';
import {matchesOf, matchWords, nearestMatch, nextMatch, residualWords} from '../src/drawing/matches.js';
import type {PictureHeader} from '../src/protocol.js';

const headerOf = (...marks: object[]): PictureHeader => ({matches: {marks}}) as unknown as PictureHeader;
const hand = {
  name: 'hand',
  u_left: [100, 110, 100],
  v_left: [50, 50, 60],
  u_right: [80, 90, null],
  v_right: [50, 50, 60],
  residual: [0.1, -0.5, null],
};

test("each image has its own end of a frame's matches", () => {
  const left = matchesOf(headerOf(hand), 'left');
  const right = matchesOf(headerOf(hand), 'right');
  assert.deepEqual(left[0], {mark: 'hand', u: 100, v: 50, disparity: -20, residual: 0.1});
  assert.deepEqual(right[0], {mark: 'hand', u: 80, v: 50, disparity: 20, residual: 0.1});
  assert.equal(right.length, 2, 'a match with a null has no place in that image');
  assert.deepEqual(matchesOf(undefined, 'left'), []);
  assert.deepEqual(matchesOf({matches: null} as PictureHeader, 'left'), []);
});

test('residuals are told in px, whatever their sign, and what is no number is no 0', () => {
  const matches = matchesOf(headerOf(hand), 'left');
  assert.equal(residualWords(matches), '3 residuals: mean 0.30, max 0.50 px, 1 not a number');
  assert.equal(residualWords(matches.slice(0, 2)), '2 residuals: mean 0.30, max 0.50 px');
  assert.equal(residualWords(matches.slice(2)), '1 residuals: not a number');
  assert.equal(residualWords([]), '');
  assert.equal(matchWords(matches[1]!), 'match of hand, residual -0.50 px');
  assert.equal(matchWords(matches[2]!), 'match of hand, residual not a number');
});

test('the nearest match is told, where one is near', () => {
  const matches = matchesOf(headerOf(hand), 'left');
  assert.equal(nearestMatch(matches, 108, 51, 4)?.u, 110);
  assert.equal(nearestMatch(matches, 105, 50, 4), null);
});

test('from match to match it goes in reading order, and round', () => {
  const matches = matchesOf(headerOf(hand), 'left');
  const places = [];
  let at = {u: 0, v: 0};
  for (let i = 0; i < 4; i++) {
    at = nextMatch(matches, at.u, at.v, 1)!;
    places.push([at.u, at.v]);
  }
  assert.deepEqual(places, [
    [100, 50],
    [110, 50],
    [100, 60],
    [100, 50],
  ]);
  assert.deepEqual(nextMatch(matches, 100, 50, -1), matches[2]);
  assert.equal(nextMatch([], 0, 0, 1), null);
});
