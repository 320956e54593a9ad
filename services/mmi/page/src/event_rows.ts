import type {RobotEvent} from './protocol.js';

/** Rows that are shown at first, and how many more each time that is asked for. */
export const kRowsAtATime = 1000;

export interface EventRows {
  /** Newest first. */
  rows: RobotEvent[];
  /** What stands before and behind them in time, and is not shown. */
  earlier: number;
  later: number;
}

/**
 * At most `at_most` of the events (oldest first): the newest, or, where the one with the number `current` is none of
 * these, those around it.
 */
export function rowsOf(events: RobotEvent[], at_most: number, current: number | null): EventRows {
  let end = events.length;
  const index = current === null ? -1 : events.findIndex((event) => event.number === current);
  if (index >= 0 && index < end - at_most) end = Math.min(end, index + 1 + Math.floor(at_most / 2));
  const begin = Math.max(0, end - at_most);
  return {rows: events.slice(begin, end).reverse(), earlier: begin, later: events.length - end};
}

/** What is said of a list that is not whole; empty when it is. `forgotten`: events that the page no longer has. */
export function wordsOf({rows, earlier, later}: EventRows, forgotten: number): string {
  const all = rows.length + earlier + later;
  const count = (number: number): string => number.toLocaleString('en');
  const shown =
    later > 0
      ? `${count(earlier + 1)} to ${count(earlier + rows.length)} of ${count(all)} shown`
      : earlier > 0
        ? `newest ${count(rows.length)} of ${count(all)} shown`
        : '';
  const gone = forgotten > 0 ? `${count(forgotten)} earlier ones are no longer kept` : '';
  return [shown, gone].filter(Boolean).join('; ');
}
