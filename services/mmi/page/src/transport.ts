import {microseconds} from './format.js';
import type {RobotEvent} from './protocol.js';
import {Seeker} from './seeker.js';
import {connection, showPastPicture, store} from './session.js';

const seeker = new Seeker((at) => connection.send({type: 'seek', utime: String(at)}));
let seeks = store.seeks;
store.hear((change) => {
  if (change === 'choice') goBackToWhereItWas();
  if (change !== 'state') return;
  if (store.seeks !== seeks) seeker.arrived(performance.now());
  else seeker.work(performance.now());
  seeks = store.seeks;
});

/** A log whose source was lost is shown from its begin again: goes to where it was, or was being sought; plays on. */
function goBackToWhereItWas(): void {
  const left = store.takeLeft();
  if (!left) return;
  const at = seeker.target ?? microseconds(left.utime);
  seeker.forget();
  goTo(at);
  if (left.playing) connection.send({type: 'play', speed: left.speed});
}

/** us; where a log is being sought; null when it is where it shall be. */
export function soughtTime(): number | null {
  return seeker.target;
}

/** The time that is shown, us. */
export function shownTime(): number {
  if (store.is_log) return microseconds(store.play?.utime ?? store.now);
  return store.shown_past ?? store.now;
}

export function plays(): boolean {
  return store.is_log ? (store.play?.playing ?? false) : store.paused_at === null;
}

/** What can be gone to: a log from end to end, or what the page still remembers. us. */
export function range(): {begin: number; end: number} {
  const log = store.hello?.log;
  if (log) return {begin: microseconds(log.begin), end: microseconds(log.end)};
  return {begin: store.kept_begin ?? store.now, end: store.now};
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
    const {begin, end} = range();
    seeker.seek(Math.round(Math.min(Math.max(at, begin), end)), performance.now());
    return;
  }
  const {begin, end} = range();
  const within = Math.round(Math.min(Math.max(at, begin), end));
  store.pauseAt(within);
  showPastPicture(within);
}

/** Goes to the time (us) that an address holds; where it is not kept, the page says so and shows the newest. */
export function goToAddressed(at: number): void {
  if (store.is_log) {
    goTo(at);
    return;
  }
  store.recall(at);
  if (store.paused_at !== null) showPastPicture(store.paused_at);
}

export function showNewest(): void {
  if (store.is_log) goTo(range().end);
  else store.pauseAt(null);
}

/** us; of the picture gone to or, where a time between two was, of the one that is drawn: the next may have come since. */
function pictureTime(): number {
  const at = shownTime();
  if (store.pictures.at(at)?.at === at || store.picture === null) return at;
  return microseconds(store.picture.header.at);
}

/** One frame on or back. */
export function step(by: 1 | -1): void {
  if (store.is_log) {
    connection.send({type: 'step', by});
    return;
  }
  const next = store.pictures.step(pictureTime(), by);
  if (next !== null) goTo(next);
}

/** The first event after, or the last one before, a time (us). */
function eventFrom(events: RobotEvent[], at: number, by: 1 | -1): RobotEvent | null {
  if (by > 0) return events.find((event) => microseconds(event.at) > at) ?? null;
  let before: RobotEvent | null = null;
  for (const event of events) {
    if (microseconds(event.at) >= at) break;
    before = event;
  }
  return before;
}

export function goToEvent(by: 1 | -1): void {
  const event = eventFrom(store.events, soughtTime() ?? shownTime(), by);
  if (event) goTo(microseconds(event.at));
}
