import {microseconds} from './format.js';
import type {RobotEvent} from './protocol.js';
import {connection, showPastPicture, store} from './session.js';

/** The time that is shown, us. */
export function shownTime(): number {
  if (store.is_log) return microseconds(store.play?.utime ?? store.now);
  return store.paused_at ?? store.now;
}

export function plays(): boolean {
  return store.is_log ? (store.play?.playing ?? false) : store.paused_at === null;
}

/** What can be gone to: a log from end to end, or what the page still remembers. us. */
export function range(): {begin: number; end: number} {
  const log = store.hello?.log;
  if (log) return {begin: microseconds(log.begin), end: microseconds(log.end)};
  return {begin: store.history.begin ?? store.now, end: store.now};
}

let speed = 1;

export function chosenSpeed(): number {
  return store.is_log && store.play?.playing ? store.play.speed : speed;
}

export function setSpeed(value: number): void {
  speed = value;
  if (store.is_log && plays()) connection.send({type: 'play', speed});
  store.tell('choice');
}

export function playOrPause(): void {
  if (store.is_log) {
    if (plays()) connection.send({type: 'pause'});
    else connection.send({type: 'play', speed});
    return;
  }
  if (store.paused_at === null) goTo(store.now);
  else showNewest();
}

export function goTo(at: number): void {
  if (!Number.isFinite(at)) return;
  if (store.is_log) {
    connection.send({type: 'seek', utime: String(Math.round(at))});
    return;
  }
  const {begin, end} = range();
  const within = Math.min(Math.max(at, begin), end);
  store.pauseAt(within);
  showPastPicture(within);
}

export function showNewest(): void {
  if (store.is_log) goTo(range().end);
  else store.pauseAt(null);
}

/** One frame on or back. */
export function step(by: 1 | -1): void {
  if (store.is_log) {
    connection.send({type: 'step', by});
    return;
  }
  const next = store.pictures.step(shownTime(), by);
  if (next !== null) goTo(next);
}

/** The first event after, or the last one before, a time (us). */
export function eventFrom(events: RobotEvent[], at: number, by: 1 | -1): RobotEvent | null {
  if (by > 0) return events.find((event) => microseconds(event.at) > at) ?? null;
  let before: RobotEvent | null = null;
  for (const event of events) {
    if (microseconds(event.at) >= at) break;
    before = event;
  }
  return before;
}

export function goToEvent(by: 1 | -1): void {
  const event = eventFrom(store.events, shownTime(), by);
  if (event) goTo(microseconds(event.at));
}
