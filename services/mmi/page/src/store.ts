import {clock, microseconds} from './format.js';
import {GoalAnchors} from './goal_anchor.js';
import {PictureHistory, TextHistory} from './history.js';
import {Moment, partId, slotId, type Parts} from './moment.js';
import {finitePose} from './numbers.js';
import type {ShownPicture} from './pictures.js';
import type {Hello, Play, RobotEvent, Slot, Update} from './protocol.js';
import type {Life} from './connection.js';
import {withoutPatches} from './slim.js';

/** What changed: elements redraw at once for the first four, and at their own pace for the others. */
export type Change = 'choice' | 'picture' | 'cursor' | 'operate' | 'state' | 'events';

const kPictureBytes = 40e6;
const kPictureAge_us = 20e6;
const kTextBytes = 60e6;
const kTextAge_us = 300e6;
const kEventsAtMost = 5000;
/** Of a log all are kept, which mmi bounds. */
const kEventsOfLogAtMost = 200000;
const kTrailAtMost = 8000;
/** us; a robot's pose of longer before or after a goal is not where it was when it heard of the goal. */
const kPoseHolds_us = 1e6;

/** All that the page knows, and what of it is chosen to be shown. */
export class Store {
  hello: Hello | null = null;
  life: Life = 'lost';
  life_why = '';
  life_since_ms = performance.now();
  now = NaN;
  play: Play | null = null;
  /** Counts up when what was known before is void. */
  generation = 0;
  /** Counts the times that the source has gone elsewhere in its log. */
  seeks = 0;
  events: RobotEvent[] = [];
  /** How many earlier ones are no longer kept. */
  events_forgotten = 0;
  picture: ShownPicture | null = null;
  /** Where the robot was, oldest first. */
  trail: {at: number; x: number; y: number}[] = [];

  /** us; null: the newest. What is shown of it is `shown_past`. */
  paused_at: number | null = null;
  /** Why another time is shown than was asked for; empty: it is not. */
  notice = '';
  /** Name of a mark, or a tag's uid. */
  selected: string | null = null;
  /** us, the time under the pointer in the plots, and the one that differences are taken from. */
  cursor: number | null = null;
  reference: number | null = null;

  readonly pictures = new PictureHistory(kPictureBytes, kPictureAge_us);
  /** Of a log: of all its stretches that have been shown. */
  history = new TextHistory(kTextBytes, kTextAge_us);
  readonly goals = new GoalAnchors();

  private readonly newest = new Map<string, unknown>();
  private readonly hearers = new Set<(change: Change) => void>();
  private past: Moment | null = null;
  private present: Moment | null = null;
  /** us, of the first that was heard of the source: the present state was told then, and nothing of before. */
  private joined_at: number | null = null;
  /** Where a log was left when its source was lost. */
  private left: Play | null = null;

  hear(hearer: (change: Change) => void): () => void {
    this.hearers.add(hearer);
    return () => this.hearers.delete(hearer);
  }

  tell(change: Change): void {
    for (const hearer of this.hearers) hearer(change);
  }

  get is_log(): boolean {
    return this.hello?.mode === 'log';
  }

  get moment(): Moment {
    const at = this.shown_past;
    if (at === null) return this.moment_live;
    if (this.past?.now !== at) {
      this.past = new Moment(
        at,
        remembering((id) => this.history.at(id, at)),
        () => this.history.ids(),
      );
    }
    return this.past;
  }

  /** us; the oldest time of which all is known that was known then; null while nothing has been heard. */
  get kept_begin(): number | null {
    return this.joined_at === null ? null : Math.max(this.joined_at, this.history.begin ?? -Infinity);
  }

  /** us; where it was paused or, when that is no longer kept, the oldest time that is; null: the newest is shown. */
  get shown_past(): number | null {
    return this.paused_at === null ? null : Math.max(this.paused_at, this.kept_begin ?? -Infinity);
  }

  /** The time at which it was paused is no longer kept. */
  get past_is_lost(): boolean {
    return this.paused_at !== null && this.shown_past !== this.paused_at;
  }

  /** The newest, whatever is shown: Stop and its answers know no past. */
  get moment_live(): Moment {
    this.present ??= new Moment(
      this.now,
      (id) => this.newest.get(id),
      () => this.newest.keys(),
    );
    return this.present;
  }

  /** The events until the moment that is shown. */
  get events_shown(): RobotEvent[] {
    const at = this.shown_past;
    return at === null ? this.events_until_now : until(this.events, at);
  }

  /** The events until the source's present: of a log later ones are known too. */
  get events_until_now(): RobotEvent[] {
    return this.is_log ? until(this.events, this.now) : this.events;
  }

  private get events_at_most(): number {
    return this.is_log ? kEventsOfLogAtMost : kEventsAtMost;
  }

  onHello(hello: Hello): void {
    const named = (one: Hello): string => JSON.stringify([one.mode, one.bus, one.log?.begin]);
    const same = this.hello !== null && named(this.hello) === named(hello);
    this.hello = hello;
    if (!same) this.forget();
    else if (this.is_log) this.left = this.play;
    this.newest.clear();
    this.goals.interrupt();
    this.events = [];
    this.events_forgotten = 0;
    this.keepEvents(hello.events);
    this.tell('choice');
    this.tell('events');
  }

  onUpdate(update: Update): void {
    const now = microseconds(update.now);
    if (update.play) this.play = update.play;
    if (update.anew) this.beginAnew();
    this.now = now;
    if (Number.isFinite(now)) this.join(now);
    this.present = null;
    for (const slot of update.slots ?? []) this.onSlot(slot, now);
    for (const name of ['arm', 'places', 'floor', 'troubles', 'stop', 'figures', 'latency'] as const) {
      if (update[name] !== undefined) this.onPart(name, update[name] as Parts[typeof name], now);
    }
    this.placeGoal(update.slots ?? []);
    if (update.events && update.events.length > 0) this.onEvents(update.events);
    this.tell('state');
  }

  onLife(life: Life, why: string): void {
    if (life !== this.life) this.life_since_ms = performance.now();
    this.life = life;
    this.life_why = why;
    this.tell('choice');
  }

  /** Shows the past at `at` (us), or, with null, the newest again. */
  pauseAt(at: number | null): void {
    const turns = (this.paused_at === null) !== (at === null) || this.notice !== '';
    this.paused_at = at === null ? null : Math.round(at);
    this.past = null;
    this.notice = '';
    // A time that is dragged along is drawn at each element's own pace.
    this.tell(turns ? 'choice' : 'state');
  }

  /** Shows the past at `at` (us) if it is kept; else the newest, and says why. */
  recall(at: number): void {
    const begin = this.kept_begin;
    if (begin !== null && at >= begin && at <= this.now) this.pauseAt(at);
    else this.showNewest(`${clock(at).slice(0, 8)} UTC is not kept by this page: the newest is shown`);
  }

  /** Once after a log that had been lost is there again: where it was; else null. */
  takeLeft(): Play | null {
    const left = this.left;
    this.left = null;
    return left;
  }

  select(what: string | null): void {
    this.selected = this.selected === what ? null : what;
    this.tell('choice');
  }

  setCursor(at: number | null): void {
    if (at === this.cursor) return;
    this.cursor = at;
    this.tell('cursor');
  }

  setReference(at: number | null): void {
    this.reference = at;
    this.tell('cursor');
  }

  private join(now: number): void {
    this.joined_at ??= now;
    this.goals.advance(now);
  }

  private onSlot(slot: Slot, now: number): void {
    const slim = slot.channel.endsWith('MARK_DETECTION') ? withoutPatches(slot) : slot;
    const id = slotId(slot.channel, slot.key);
    this.newest.set(id, slim);
    this.history.add(id, Math.min(microseconds(slot.at), now), slim);
    const pose = slot.channel === 'ROBOT_POSE' ? slot.message?.pose : null;
    if (pose && Number.isFinite(pose.x) && Number.isFinite(pose.y)) {
      this.trail.push({at: microseconds(slot.at), x: pose.x, y: pose.y});
      if (this.trail.length > kTrailAtMost) this.trail.splice(0, kTrailAtMost / 4);
    }
  }

  /** A goal in the robot's frame means the robot's at its arrival, whoever looks at it, and when. */
  private placeGoal(slots: Slot[]): void {
    const slot = slots.find((one) => one.channel === 'BASE_GOAL' && one.message);
    if (!slot) return;
    const at = microseconds(slot.at);
    const id = slotId('ROBOT_POSE', '');
    const poses = [this.history.at(id, at), this.newest.get(id)] as (Slot | undefined)[];
    const near = poses.find((pose) => pose && Math.abs(microseconds(pose.at) - at) <= kPoseHolds_us);
    this.goals.observe(slot.message, at, finitePose(near?.message?.pose));
  }

  private onPart<Name extends keyof Parts>(name: Name, value: Parts[Name], now: number): void {
    this.newest.set(partId(name), value);
    // A log's past is asked of mmi; what is kept of it is for curves of messages.
    if (!this.is_log) this.history.add(partId(name), now, value);
  }

  private onEvents(events: RobotEvent[]): void {
    const newest = this.events[this.events.length - 1]?.number ?? -Infinity;
    const fresh = events.filter((event) => event.number > newest);
    if (fresh.length === 0) return;
    this.keepEvents(fresh);
    this.tell('events');
  }

  private keepEvents(fresh: RobotEvent[]): void {
    const all = [...this.events, ...fresh];
    this.events = all.slice(-this.events_at_most);
    this.events_forgotten += all.length - this.events.length;
  }

  private showNewest(why: string): void {
    this.pauseAt(null);
    this.notice = why;
    this.tell('choice');
  }

  private beginAnew(): void {
    const stop = this.newest.get(partId('stop'));
    this.newest.clear();
    this.seeks++;
    this.trail = [];
    if (stop !== undefined) this.newest.set(partId('stop'), stop);
    this.goals.interrupt();
    // A log does not change: what was heard of it stays true.
    if (this.is_log) return;
    this.history.forget();
    this.goals.forget();
    this.joined_at = null;
    this.generation++;
    if (this.paused_at !== null) this.showNewest('The source began anew: the newest is shown');
  }

  private forget(): void {
    this.history = new TextHistory(kTextBytes, this.is_log ? Infinity : kTextAge_us);
    this.generation++;
    this.goals.forget();
    this.joined_at = null;
    this.play = null;
    this.left = null;
    this.notice = '';
    this.trail = [];
    this.pictures.forget();
    this.picture = null;
    this.paused_at = null;
    this.past = null;
    this.present = null;
    this.now = NaN;
  }
}

function until(events: RobotEvent[], at: number): RobotEvent[] {
  let low = 0;
  let high = events.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (microseconds(events[middle]!.at) <= at) low = middle + 1;
    else high = middle;
  }
  return events.slice(0, low);
}

function remembering(find: (id: string) => unknown): (id: string) => unknown {
  const found = new Map<string, unknown>();
  return (id) => {
    if (!found.has(id)) found.set(id, find(id));
    return found.get(id);
  };
}
