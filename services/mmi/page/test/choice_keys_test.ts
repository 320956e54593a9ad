import assert from 'node:assert/strict';
import test from 'node:test';
import {afterKey, type ListState} from '../src/choice_keys.js';

const closed: ListState = {open: false, offered: 1};
const open: ListState = {open: true, offered: 1};

test('Escape closes a list without a choice, and goes on to stop the robot', () => {
  assert.deepEqual(afterKey(open, 'Escape', 4), {open: false, offered: 1, chooses: false, taken: false});
  assert.equal(afterKey(closed, 'Escape', 4), null);
});

test('a list is opened, gone through and chosen from by keys', () => {
  for (const key of ['Enter', ' ', 'ArrowDown', 'ArrowUp']) {
    assert.deepEqual(afterKey(closed, key, 4), {open: true, offered: 1, chooses: false, taken: true});
  }
  const offered = (key: string): number => afterKey(open, key, 4)!.offered;
  assert.deepEqual(['ArrowDown', 'ArrowUp', 'Home', 'End'].map(offered), [2, 0, 0, 3]);
  for (const key of ['Enter', ' ']) {
    assert.deepEqual(afterKey(open, key, 4), {open: false, offered: 1, chooses: true, taken: true});
  }
  assert.deepEqual(afterKey(open, 'Tab', 4), {open: false, offered: 1, chooses: true, taken: false});
});

test('a list ends at its ends, and an empty one is not opened', () => {
  assert.equal(afterKey({open: true, offered: 3}, 'ArrowDown', 4)!.offered, 3);
  assert.equal(afterKey({open: true, offered: 0}, 'ArrowUp', 4)!.offered, 0);
  assert.equal(afterKey(closed, 'Enter', 0), null);
});

test("letters are the page's, open or not", () => {
  for (const list of [open, closed]) assert.equal(afterKey(list, 's', 4), null);
});
