import {tagPlaces, tagStates, type TagState} from './drawing/floor_map.js';
import {microseconds} from './format.js';
import type {FloorRound, TagScene} from './protocol.js';

export interface TagRow {
  uid: string;
  state: TagState;
  place: [number, number] | null;
  rssi: number | null;
  /** us, when it was last read. */
  at: number;
  count: number;
}

const kRowsAtMost = 200;
/** The tags that nothing was said of for longest are forgotten beyond that. */
const kKnownAtMost = 1000;

/** What rounds of the reader said of tags, the last word of each. */
export class TagMemory {
  /** The one spoken of last at the end. */
  private rows_ = new Map<string, TagRow>();
  private utime = -Infinity;

  observe(floor: FloorRound | null, tags: TagScene[]): void {
    if (!floor) return;
    const utime = microseconds(floor.utime);
    if (utime === this.utime) return;
    if (utime < this.utime) this.rows_.clear();
    this.utime = utime;
    const places = tagPlaces(tags);
    const states = tagStates(floor);
    for (const row of this.rows_.values()) row.state = 'idle';
    for (const tag of floor.read) {
      this.rows_.delete(tag.uid);
      this.rows_.set(tag.uid, {
        uid: tag.uid,
        state: 'read',
        place: tag.place,
        rssi: tag.rssi,
        at: microseconds(tag.at),
        count: tag.count,
      });
    }
    for (const [uid, state] of states) {
      const row = this.rows_.get(uid) ?? {uid, state, place: places.get(uid) ?? null, rssi: null, at: NaN, count: 0};
      row.state = state;
      this.rows_.delete(uid);
      this.rows_.set(uid, row);
    }
    const oldest = this.rows_.keys();
    while (this.rows_.size > kKnownAtMost) this.rows_.delete(oldest.next().value!);
  }

  get size(): number {
    return this.rows_.size;
  }

  /** Newest first; at most 200, and none read after `now` (us). */
  rows(now: number): TagRow[] {
    const known = [...this.rows_.values()].filter((row) => !(row.at > now));
    const rank = (row: TagRow): number => (row.state === 'idle' ? 1 : 0);
    return known
      .sort((a, b) => rank(a) - rank(b) || (b.at || 0) - (a.at || 0) || (a.uid < b.uid ? -1 : 1))
      .slice(0, kRowsAtMost);
  }
}
