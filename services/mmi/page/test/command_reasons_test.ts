import assert from 'node:assert/strict';
import test from 'node:test';
import {grouped, whyNoControl, whyNot, type CommandFacts} from '../src/operate/command_reasons.js';
import type {CommandKind, Desk} from '../src/protocol.js';

const kKinds: CommandKind[] = ['start', 'carry', 'abort', 'home', 'drive', 'reset'];
const desk: Desk = {
  session: '7',
  may: true,
  holder: 'you',
  since: '0',
  targets: ['red_book'],
  why: {start: '', home: '', drive: '', reset: '', abort: ''},
};
const good: CommandFacts = {
  open: true,
  desk,
  holds: true,
  waiting: [],
  selected: 'red_book',
  place: {x: 0, y: 0, heading: 0},
};
const all = (facts: Partial<CommandFacts>): string[] => kKinds.map((kind) => whyNot(kind, {...good, ...facts}));
const every = (why: string): string[] => kKinds.map(() => why);

test('with a lease, a target and a place all works of which mmi says so', () => {
  assert.deepEqual(all({}), every(''));
  assert.equal(whyNoControl(good), '');
});

test('without connection, token or lease nothing works, and it is said what is missing', () => {
  assert.deepEqual(all({open: false}), every('no connection to mmi'));
  assert.deepEqual(all({desk: null}), every('mmi has not told yet what can be done'));
  assert.deepEqual(
    all({desk: {...desk, may: false}, holds: false}),
    every('no token: open the address that scripts/page printed'),
  );
  assert.deepEqual(all({holds: false}), every('no lease: take control first'));
  assert.deepEqual(
    all({holds: false, desk: {...desk, holder: 'another'}}),
    every('no lease: another operates; take over first'),
  );
  assert.match(whyNoControl({...good, desk: {...desk, may: false}}), /^no token/);
});

test("mmi's reason holds for its kind, and carrying is starting", () => {
  const [start, carry, abort] = all({desk: {...desk, why: {...desk.why, start: 'a task is under way'}}});
  assert.deepEqual([start, carry, abort], ['a task is under way', 'a task is under way', '']);
});

test('only what mmi names as a target can be started', () => {
  assert.deepEqual(all({selected: null}).slice(0, 3), ['no target chosen', 'no target chosen', '']);
  assert.equal(whyNot('start', {...good, selected: 'hand'}), 'no target chosen: hand is none');
});

test('without a place nothing drives, and all else works', () => {
  const drive = 'no place chosen: click on the floor in Drive, or type it there';
  assert.deepEqual(all({place: null}), ['', '', '', '', drive, '']);
});

test('what waits for its first answer holds up its like, and no abort or reset', () => {
  const busy = 'the command before it has not been answered yet';
  assert.deepEqual(all({waiting: ['home']}), [busy, busy, '', busy, busy, '']);
  assert.deepEqual(all({waiting: ['abort']}), ['', '', busy, '', '', '']);
});

test('a reason is told once, with all that it holds for', () => {
  assert.deepEqual(
    grouped([
      {name: 'A', why: 'x'},
      {name: 'B', why: ''},
      {name: 'C', why: 'y'},
      {name: 'D', why: 'x'},
    ]),
    [
      {why: 'x', names: ['A', 'D']},
      {why: 'y', names: ['C']},
    ],
  );
});
