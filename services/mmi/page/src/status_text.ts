/** What of a trouble's words stands in the status line, where there are more of them than it has room for. */

const kCut = '…';

/** The explanation with its subject: where it does not name the subject, that stands before it. */
export function withSubject(text: string, subject: string): string {
  return text.includes(subject) ? text : `${subject}: ${text}`;
}

/**
 * The explanation, or as much of it as fits: letters go from its middle, none from the subject's name in it. Where not
 * even the subject fits, the subject alone is left. `fits` is asked some ten times.
 */
export function shortened(text: string, subject: string, fits: (shorter: string) => boolean): string {
  if (fits(text)) return text;
  const place = Math.max(0, text.indexOf(subject));
  const before = [...text.slice(0, place)];
  const after = [...text.slice(place + subject.length)];
  const without = (letters: number): string => {
    const larger = Math.max(before.length, after.length);
    const first = Math.min(letters, larger);
    const [from_before, from_after] =
      before.length > after.length ? [first, letters - first] : [letters - first, first];
    return cutMiddle(before, from_before) + subject + cutMiddle(after, from_after);
  };
  let too_few = 0;
  let enough = before.length + after.length;
  while (enough - too_few > 1) {
    const middle = (too_few + enough) >> 1;
    if (fits(without(middle))) enough = middle;
    else too_few = middle;
  }
  return without(enough);
}

function cutMiddle(letters: string[], count: number): string {
  if (count === 0) return letters.join('');
  const kept = letters.length - count;
  const head = letters.slice(0, Math.ceil(kept / 2)).join('');
  const tail = letters.slice(letters.length - Math.floor(kept / 2)).join('');
  return head.trimEnd() + kCut + tail.trimStart();
}
