import assert from 'node:assert/strict';
import test from 'node:test';
import {CommandStamps} from '../src/operate/command_stamps.js';

test('a conversation counts its commands from 1, each number once', () => {
  const stamps = new CommandStamps();
  assert.deepEqual(
    [0, 0, 0].map(() => stamps.next('a', 0).seq),
    [1, 2, 3],
  );
  assert.equal(stamps.next('b', 0).seq, 1);
  assert.equal(stamps.next('b', 0).seq, 2);
});

test('a command expires 1.5 s on, as a text of whole microseconds', () => {
  const stamps = new CommandStamps();
  assert.deepEqual(stamps.next('9223372036854775807', 1_700_000_000_000_000.25), {
    session: '9223372036854775807',
    seq: 1,
    expires: '1700000001500000',
  });
});
