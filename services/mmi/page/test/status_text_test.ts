import assert from 'node:assert/strict';
import test from 'node:test';
import {shortened, withSubject} from '../src/status_text.js';

const atMost =
  (letters: number) =>
  (text: string): boolean =>
    [...text].length <= letters;

const text = 'visual-servo gets no picture any more (frames of the left camera are older than 0.5 s since 12:26:40)';

test('a trouble names its subject once', () => {
  assert.equal(withSubject('something stands in the way', 'base'), 'base: something stands in the way');
  assert.equal(withSubject('arm does not say any more', 'arm'), 'arm does not say any more');
  assert.equal(withSubject('waits', ''), 'waits');
});

test('an explanation that fits is left as it is', () => {
  assert.equal(shortened(text, 'visual-servo', atMost(text.length)), text);
});

test('of a longer one as much is cut as must be, from its middle', () => {
  for (const room of [40, 60, 80, text.length - 1]) {
    const short = shortened(text, 'visual-servo', atMost(room));
    assert.ok(short.length <= room && short.length > room - 4, `${short.length} letters where ${room} fit`);
    assert.match(short, /^visual-servo gets.*….*:40\)$/);
  }
});

test("the subject's name is never cut, wherever it stands", () => {
  for (const subject of ['visual-servo', 'frames of the left camera', 'since 12:26:40)']) {
    for (let room = subject.length + 2; room < text.length; room++) {
      const short = shortened(text, subject, atMost(room));
      assert.ok(short.includes(subject), short);
      assert.ok(short.length <= room, `${short.length} letters where ${room} fit`);
    }
  }
});

test('where nothing fits the subject alone is left', () => {
  assert.equal(shortened(text, 'frames', atMost(3)), '…frames…');
  assert.equal(shortened('base: lost', 'base', atMost(0)), 'base…');
  assert.equal(shortened('', '', atMost(-1)), '');
});

test('a letter of two code units is cut whole', () => {
  const short = shortened('😀'.repeat(20), '', atMost(7));
  assert.equal(short, `${'😀'.repeat(3)}…${'😀'.repeat(3)}`);
});
