import assert from 'node:assert/strict';
import test from 'node:test';
import {AnswerList, fateWords} from '../src/operate/answer_list.js';
import type {Answer} from '../src/protocol.js';

const answer = (seq: number | string, state: Answer['state'], text = '', code = ''): Answer => ({seq, state, code, text});
const words = (list: AnswerList): string[] => list.entries.map(fateWords);

test('the newest stands first, and 20 are kept', () => {
  const list = new AnswerList();
  for (let seq = 1; seq <= 25; seq++) list.add(seq, 'home', 'Home', 0);
  assert.deepEqual([list.entries.length, list.entries[0]!.seq, list.entries[19]!.seq], [20, 25, 6]);
});

test('each command tells its own way, in words', () => {
  const list = new AnswerList();
  list.add(1, 'start', 'Start: red_book', 0);
  list.add(2, 'abort', 'Abort', 0);
  list.observe([answer('1', 'sent'), answer(2, 'refused', 'no task is under way', 'cannot')]);
  assert.deepEqual(words(list), ['refused (cannot), nothing was sent: no task is under way', 'sent to the robot']);
  list.observe([answer(1, 'under_way', 'LOOK'), answer(1, 'done', 'lifted')]);
  assert.equal(words(list)[1], 'done: lifted');
});

test('what got no answer may have been done', () => {
  const list = new AnswerList();
  list.add(1, 'home', 'Home', 0);
  assert.equal(list.step(2900), false);
  assert.equal(list.step(3100), true);
  assert.equal(words(list)[0], 'no answer: it may have been done; look before you try again');
  list.observe([answer(1, 'unanswered', 'no answer from task-manager')]);
  assert.match(words(list)[0]!, /^no answer: it may have been done; .* \(no answer from task-manager\)$/);
});

test('a late answer still counts', () => {
  const list = new AnswerList();
  list.add(1, 'home', 'Home', 0);
  list.step(5000);
  list.observe([answer(1, 'done', 'home')]);
  assert.equal(words(list)[0], 'done: home');
});

test('what was open when the connection went stays unanswered, whatever the next conversation tells', () => {
  const list = new AnswerList();
  list.add(1, 'home', 'Home', 0);
  list.add(2, 'start', 'Start: red_book', 0);
  list.add(3, 'abort', 'Abort', 0);
  list.observe([answer(2, 'under_way', 'LOOK'), answer(3, 'done', 'aborted')]);
  list.disconnect();
  list.observe([answer(1, 'done', 'of another'), answer(2, 'done', 'of another')]);
  assert.deepEqual(
    list.entries.map(({fate}) => fate),
    ['done', 'unanswered', 'unanswered'],
  );
  assert.match(words(list)[1]!, /look before you try again \(it was under way, and goes on\)$/);
});

test('what mmi has not taken up waits; what is under way or over does not', () => {
  const list = new AnswerList();
  list.add(1, 'home', 'Home', 0);
  list.add(2, 'abort', 'Abort', 0);
  assert.deepEqual(list.waiting, ['abort', 'home']);
  list.observe([answer(1, 'sent'), answer(2, 'refused')]);
  assert.deepEqual(list.waiting, ['home']);
  list.observe([answer(1, 'under_way')]);
  assert.deepEqual(list.waiting, []);
});
