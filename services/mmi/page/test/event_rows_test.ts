import assert from 'node:assert/strict';
import test from 'node:test';
import {rowsOf, wordsOf} from '../src/event_rows.js';
import type {RobotEvent} from '../src/protocol.js';

const events = Array.from({length: 5000}, (_, number) => ({number}) as unknown as RobotEvent);
const numbers = (rows: RobotEvent[]): number[] => [rows[0]!.number, rows[rows.length - 1]!.number];

test('a list that is cut shows the newest, and says how many of how many', () => {
  const shown = rowsOf(events, 1000, 4999);
  assert.deepEqual(numbers(shown.rows), [4999, 4000]);
  assert.equal(wordsOf(shown, 0), 'newest 1,000 of 5,000 shown');
  const more = rowsOf(events, 2000, 4999);
  assert.equal(wordsOf(more, 7), 'newest 2,000 of 5,000 shown; 7 earlier ones are no longer kept');
});

test('a list that is whole needs no word, but for what is no longer kept', () => {
  const shown = rowsOf(events.slice(0, 10), 1000, null);
  assert.equal(shown.rows.length, 10);
  assert.equal(wordsOf(shown, 0), '');
  assert.equal(wordsOf(shown, 3), '3 earlier ones are no longer kept');
});

test('of a log the current event is among those shown, and it is said which they are', () => {
  const shown = rowsOf(events, 1000, 100);
  assert.deepEqual(numbers(shown.rows), [600, 0]);
  const middle = rowsOf(events, 1000, 2000);
  assert.deepEqual(numbers(middle.rows), [2500, 1501]);
  assert.equal(wordsOf(middle, 0), '1,502 to 2,501 of 5,000 shown');
  assert.equal(rowsOf(events, 5000, 100).later, 0);
});
