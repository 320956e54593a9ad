import assert from 'node:assert/strict';
import test from 'node:test';
import {Operator} from '../src/operate/operator.js';
import type {CommandWord, Desk, LeaseWord, Update} from '../src/protocol.js';

const kDesk: Desk = {
  session: '4611686018427387904',
  may: true,
  holder: 'none',
  since: '0',
  targets: ['red_book'],
  why: {start: '', home: '', drive: '', reset: 'nothing is stopped', abort: ''},
};

/** A page whose mmi is the test. */
class Page {
  sent: (LeaseWord | CommandWord)[] = [];
  socket = true;
  drawn = 0;
  readonly operator = new Operator(
    (word) => {
      if (this.socket) this.sent.push(word);
      return this.socket;
    },
    () => ++this.drawn,
  );

  hears(update: Partial<Update>, at_ms = 0): void {
    this.operator.onUpdate({type: 'update', now: '1700000000000000', ...update}, at_ms);
  }
  connects(desk: Partial<Desk> | null = {}): Page {
    this.operator.onHello();
    this.operator.onLife('open');
    this.hears(desk ? {desk: {...kDesk, ...desk}} : {});
    return this;
  }
  operates(): Page {
    this.connects().operator.toggleControl(0);
    this.hears({desk: {...kDesk, holder: 'you'}});
    this.sent = [];
    return this;
  }
  get commands(): CommandWord[] {
    return this.sent.filter((word): word is CommandWord => word.type === 'command');
  }
}

test('where mmi tells of no desk, as of a log, nothing is enabled', () => {
  const {operator} = new Page().connects(null);
  assert.equal(operator.enabled, false);
  assert.equal(operator.command('home', null, 0), false);
});

test('a command carries session, number and expiry by the clock of mmi', () => {
  const page = new Page().operates();
  page.hears({now: '1700000007000000'}, 900);
  assert.equal(page.operator.command('start', 'red_book', 1000), true);
  assert.deepEqual(page.sent, [
    {
      type: 'command',
      session: kDesk.session,
      seq: 1,
      expires: '1700000008600000',
      kind: 'start',
      target: 'red_book',
    },
  ]);
});

test('a drive carries the place that is wished', () => {
  const page = new Page().operates();
  page.operator.wish({x: 0.2, y: 0.95, heading: 1.5});
  page.operator.command('drive', null, 0);
  assert.deepEqual(page.commands[0]!.place, [0.2, 0.95, 1.5]);
  assert.equal(page.commands[0]!.target, undefined);
});

test('a button that cannot work sends nothing', () => {
  const page = new Page().connects();
  for (const kind of ['start', 'carry', 'abort', 'home', 'drive', 'reset'] as const) {
    assert.equal(page.operator.command(kind, 'red_book', 0), false);
  }
  page.operates();
  assert.equal(page.operator.command('reset', null, 0), false);
  assert.equal(page.operator.command('start', 'hand', 0), false);
  assert.deepEqual(page.commands, []);
});

test('without a token control is not even asked for', () => {
  const page = new Page().connects({may: false});
  page.operator.toggleControl(0);
  assert.deepEqual(page.sent, []);
});

test('a second click before the answer sends nothing', () => {
  const page = new Page().operates();
  page.operator.command('home', null, 0);
  page.operator.command('home', null, 10);
  assert.equal(page.commands.length, 1);
});

test('what no socket takes is not sent later, and has not been commanded', () => {
  const page = new Page().operates();
  page.socket = false;
  assert.equal(page.operator.command('home', null, 0), false);
  page.socket = true;
  page.operator.onLife('lost');
  page.connects();
  page.operator.step(1000, true);
  assert.deepEqual(page.sent, []);
  assert.equal(page.operator.answers.entries.length, 0);
});

test('with the connection go lease, session and answers; the next conversation counts anew', () => {
  const page = new Page().operates();
  page.operator.command('home', null, 0);
  page.operator.onLife('lost');
  assert.equal(page.operator.desk, null);
  assert.equal(page.operator.enabled, true);
  assert.equal(page.operator.loss, 'connection');
  assert.match(page.operator.whyNot('abort', null), /no connection/);
  page.connects({session: '5'});
  assert.equal(page.operator.holder, 'none');
  page.operator.toggleControl(100);
  page.hears({desk: {...kDesk, session: '5', holder: 'you'}, answers: [{seq: 1, state: 'done', code: '', text: ''}]});
  assert.equal(page.operator.answers.entries[0]!.fate, 'unanswered');
  page.operator.command('home', null, 200);
  assert.deepEqual(
    page.commands.map(({session, seq}) => [session, seq]),
    [
      [kDesk.session, 1],
      ['5', 1],
    ],
  );
});

test('between the hello and the first update nothing of the former conversation counts', () => {
  const page = new Page().operates();
  page.operator.onHello();
  assert.equal(page.operator.command('home', null, 0), false);
  assert.match(page.operator.whyNot('home', null), /not told yet/);
});

test('while mmi is silent nothing is sent, but the lease is kept', () => {
  const page = new Page().operates();
  page.operator.onLife('silent');
  assert.equal(page.operator.command('home', null, 1000), false);
  page.operator.step(1000, true);
  assert.deepEqual(page.sent, [{type: 'lease', on: true}]);
});

test('control is taken over from another, given up, and told of when it is lost', () => {
  const page = new Page().connects({holder: 'another'});
  page.operator.toggleControl(0);
  page.hears({desk: {...kDesk, holder: 'you'}});
  page.operator.toggleControl(100);
  assert.deepEqual(page.sent, [
    {type: 'lease', on: true, take: true},
    {type: 'lease', on: false},
  ]);
  assert.equal(page.operator.holder, 'none');
  page.operates();
  const drawn = page.drawn;
  page.hears({desk: {...kDesk, holder: 'another'}}, 500);
  assert.equal(page.operator.loss, 'taken');
  assert.ok(page.drawn > drawn);
});
