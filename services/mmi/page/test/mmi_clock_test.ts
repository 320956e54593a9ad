import assert from 'node:assert/strict';
import test from 'node:test';
import {MmiClock} from '../src/operate/mmi_clock.js';

test('the clock goes on from the newest update by the time since it came', () => {
  const clock = new MmiClock();
  assert.equal(clock.at(0), null);
  clock.observe(1_700_000_000_000_000, 1000);
  assert.equal(clock.at(1000), 1_700_000_000_000_000);
  assert.equal(clock.at(1250.5), 1_700_000_000_250_500);
  clock.observe(1_700_000_005_000_000, 1300);
  assert.equal(clock.at(1310), 1_700_000_005_010_000);
});

test("a source set back is followed: its newest word counts, not its latest time", () => {
  const clock = new MmiClock();
  clock.observe(9e15, 0);
  clock.observe(1e15, 10);
  assert.equal(clock.at(10), 1e15);
});

test('what is no time is not taken, and another conversation has to tell its own', () => {
  const clock = new MmiClock();
  clock.observe(5e6, 0);
  clock.observe(NaN, 100);
  assert.equal(clock.at(100), 5.1e6);
  clock.forget();
  assert.equal(clock.at(100), null);
});
