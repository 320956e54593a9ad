import {tagPlaces, tagStates, type TagState} from './drawing/floor_map.js';
import {microseconds} from './format.js';
import type {FloorRound, Slot, TagScene} from './protocol.js';

export interface TagRow {
  uid: string;
  state: TagState;
  place: [number, number] | null;
  rssi: number | null;
  /** us, arrival of the newest round that read it. */
  at: number;
  count: number;
}

const kRowsAtMost = 200;
/** The tags that nothing was said of for longest are forgotten beyond that. */
const kKnownAtMost = 1000;

/**
 * us, when a round arrived: the reader's own times may be of another clock than the source's. `slot`: the newest
 * RFID_TAG_HITS; `now`: what is taken where that is not the round's.
 */
export function arrivalOf(floor: FloorRound | null, slot: Slot | null, now: number): number {
  const is_its = floor !== null && String(slot?.message?.utime) === String(floor.utime);
  return is_its ? microseconds(slot!.at) : now;
}

/** What rounds of the reader said of tags, the last word of each. */
export class TagMemory {
  /** The one spoken of last at the end. */
  private rows_ = new Map<string, TagRow>();
  private utime = NaN;
  private arrival = -Infinity;

  /** `arrival`: of the round, us. A round that arrived before the last one is of another time, and all is told anew. */
  observe(floor: FloorRound | null, tags: TagScene[], arrival: number): void {
    if (!floor) return;
    const utime = microseconds(floor.utime);
    if (utime === this.utime) return;
    if (arrival < this.arrival) this.rows_.clear();
    this.utime = utime;
    this.arrival = arrival;
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
        at: arrival,
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
