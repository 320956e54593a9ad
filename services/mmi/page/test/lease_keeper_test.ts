import assert from 'node:assert/strict';
import test from 'node:test';
import {LeaseKeeper} from '../src/operate/lease_keeper.js';

function held(at_ms = 0): LeaseKeeper {
  const lease = new LeaseKeeper();
  lease.ask(false, at_ms);
  lease.observe('you', at_ms);
  return lease;
}
/** When it speaks from `begin` to `end`, asked every 100 ms. */
function words(lease: LeaseKeeper, begin: number, end: number, visible = true): number[] {
  const times: number[] = [];
  for (let at = begin; at <= end; at += 100) if (lease.step(at, visible)) times.push(at);
  return times;
}

test('nothing is said before somebody asks for control', () => {
  const lease = new LeaseKeeper();
  assert.deepEqual(words(lease, 0, 10000), []);
  lease.observe('you', 0);
  assert.equal(lease.holds, false);
});

test('it is ours when mmi says so, and is renewed each second', () => {
  const lease = new LeaseKeeper();
  assert.deepEqual(lease.ask(true, 0), {type: 'lease', on: true, take: true});
  assert.equal(lease.holds, false);
  lease.observe('you', 50);
  assert.equal(lease.holds, true);
  assert.deepEqual(words(lease, 100, 4500), [1000, 2000, 3000, 4000]);
  assert.deepEqual(lease.step(5000, true), {type: 'lease', on: true});
});

test('a hidden page does not renew it; seen again in time it does at once', () => {
  const lease = held();
  assert.deepEqual(words(lease, 0, 4000, false), []);
  assert.equal(lease.holds, true);
  assert.deepEqual(words(lease, 4100, 5200), [4100, 5100]);
});

test('after 5 s without a word it is over, and is not taken anew in silence', () => {
  const lease = held();
  assert.deepEqual(words(lease, 5100, 9000), []);
  assert.equal(lease.holds, false);
  assert.equal(lease.loss, 'ended');
});

test('who takes it over is told of, and what is told to be lost is not taken back', () => {
  const lease = held();
  lease.observe('another', 500);
  assert.equal(lease.holds, false);
  assert.equal(lease.loss, 'taken');
  lease.observe('none', 7000);
  assert.deepEqual(words(lease, 7000, 9000), []);
});

test('mmi may end it, and what it told of before we asked ends nothing', () => {
  const lease = held();
  lease.observe('none', 3000);
  assert.equal(lease.loss, 'ended');
  lease.ask(false, 4000);
  lease.observe('none', 4050);
  lease.observe('you', 4100);
  assert.equal(lease.holds, true);
  assert.equal(lease.loss, null);
});

test('where another was first it is not ours', () => {
  const lease = new LeaseKeeper();
  lease.ask(false, 0);
  lease.observe('another', 50);
  assert.deepEqual(words(lease, 100, 3000), []);
  assert.equal(lease.loss, 'refused');
});

test('what is given up is neither renewed nor lost', () => {
  const lease = held();
  assert.deepEqual(lease.giveUp(), {type: 'lease', on: false});
  lease.observe('none', 2500);
  assert.deepEqual(words(lease, 2500, 9000), []);
  assert.equal(lease.loss, null);
});

test('it goes with the connection', () => {
  const lease = held();
  lease.disconnect();
  assert.equal(lease.holds, false);
  assert.equal(lease.loss, 'connection');
  lease.observe('you', 100);
  assert.deepEqual(words(lease, 1000, 3000), []);
});
