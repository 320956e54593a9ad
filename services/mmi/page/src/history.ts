/** What has been heard, bounded by bytes and by age. Kept as text: its size is then known, and nothing else holds it. */

interface Entry {
  at: number;
  text: string;
  /** Counts what was taken in. */
  number: number;
}

interface Track {
  entries: Entry[];
  first: number;
  /** The newest of what has been forgotten: it still holds until the first entry. */
  before: Entry | null;
}

const kForgottenBeforeTidying = 512;

export class TextHistory {
  private readonly tracks = new Map<string, Track>();
  private order: string[] = [];
  private order_first = 0;
  private bytes_ = 0;
  private number = 0;

  /** `byte_limit`: of the texts, one byte a character; `age_limit_us`: of the oldest against the newest. */
  constructor(
    private readonly byte_limit: number,
    private readonly age_limit_us: number,
  ) {}

  get bytes(): number {
    return this.bytes_;
  }

  /** Begin of what is known, us; null when nothing is. */
  get begin(): number | null {
    for (let i = this.order_first; i < this.order.length; i++) {
      const track = this.tracks.get(this.order[i]!)!;
      const entry = track.entries[track.first];
      if (entry) return entry.at;
    }
    return null;
  }

  ids(): string[] {
    return [...this.tracks.keys()];
  }

  /**
   * Takes in a value of `id` that holds from `at` (us) on. Values may come out of the order of time (a log is gone back
   * in); one of a time that is known takes the other's place.
   */
  add(id: string, at: number, value: unknown): void {
    const text = JSON.stringify(value);
    let track = this.tracks.get(id);
    if (!track) this.tracks.set(id, (track = {entries: [], first: 0, before: null}));
    const index = indexAfter(track.entries, track.first, at);
    const before = index > track.first ? track.entries[index - 1]! : null;
    this.bytes_ += text.length;
    if (before?.at === at) {
      this.bytes_ -= before.text.length;
      track.entries[index - 1] = {at, text, number: ++this.number};
    } else {
      track.entries.splice(index, 0, {at, text, number: ++this.number});
      this.order.push(id);
    }
    while (this.bytes_ > this.byte_limit || this.oldestIsBefore(at - this.age_limit_us)) {
      if (!this.forgetOldest()) break;
    }
  }

  /** The newest value of `id` at or before `at` (us). */
  at(id: string, at: number): unknown {
    const track = this.tracks.get(id);
    if (!track) return undefined;
    const index = indexAfter(track.entries, track.first, at);
    const entry = index > track.first ? track.entries[index - 1] : track.before;
    return entry && entry.at <= at ? JSON.parse(entry.text) : undefined;
  }

  /** All values of `id` from `begin` to `end` (us), oldest first. */
  *between(id: string, begin: number, end: number): Generator<{at: number; value: unknown}> {
    const track = this.tracks.get(id);
    if (!track) return;
    for (let i = track.first; i < track.entries.length; i++) {
      const entry = track.entries[i]!;
      if (entry.at >= begin && entry.at <= end) yield {at: entry.at, value: JSON.parse(entry.text)};
    }
  }

  /** What was taken in of `id` after the value of that number, in the order of time. */
  *after(id: string, number: number): Generator<{at: number; value: unknown; number: number}> {
    const track = this.tracks.get(id);
    if (!track) return;
    for (let i = track.first; i < track.entries.length; i++) {
      const entry = track.entries[i]!;
      if (entry.number > number) yield {at: entry.at, value: JSON.parse(entry.text), number: entry.number};
    }
  }

  forget(): void {
    this.tracks.clear();
    this.order = [];
    this.order_first = 0;
    this.bytes_ = 0;
  }

  private oldestIsBefore(at: number): boolean {
    const id = this.order[this.order_first];
    if (id === undefined) return false;
    const track = this.tracks.get(id)!;
    const entry = track.entries[track.first];
    return entry !== undefined && entry.at < at;
  }

  private forgetOldest(): boolean {
    const id = this.order[this.order_first];
    if (id === undefined) return false;
    this.order_first++;
    const track = this.tracks.get(id)!;
    const entry = track.entries[track.first]!;
    if (track.before) this.bytes_ -= track.before.text.length;
    track.before = entry;
    track.entries[track.first] = {...entry, text: ''};
    track.first++;
    if (track.first > kForgottenBeforeTidying) {
      track.entries.splice(0, track.first);
      track.first = 0;
    }
    if (this.order_first > 8 * kForgottenBeforeTidying) {
      this.order.splice(0, this.order_first);
      this.order_first = 0;
    }
    return this.order_first < this.order.length;
  }
}

/** The first index from `first` on whose time is after `at`. */
function indexAfter(entries: Entry[], first: number, at: number): number {
  let low = first;
  let high = entries.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (entries[middle]!.at <= at) low = middle + 1;
    else high = middle;
  }
  return low;
}

/** Pictures as they came, bounded by bytes and by age. */
export class PictureHistory {
  private pictures: {at: number; bytes: ArrayBuffer}[] = [];
  private bytes_ = 0;

  constructor(
    private readonly byte_limit: number,
    private readonly age_limit_us: number,
  ) {}

  get bytes(): number {
    return this.bytes_;
  }

  get size(): number {
    return this.pictures.length;
  }

  get begin(): number | null {
    return this.pictures[0]?.at ?? null;
  }

  /** A picture of the same arrival as the last one is that one again, with more known of it. */
  add(at: number, bytes: ArrayBuffer): void {
    if (this.pictures[this.pictures.length - 1]?.at === at) this.bytes_ -= this.pictures.pop()!.bytes.byteLength;
    this.pictures.push({at, bytes});
    this.bytes_ += bytes.byteLength;
    let drop = 0;
    while (
      drop < this.pictures.length - 1 &&
      (this.bytes_ > this.byte_limit || this.pictures[drop]!.at < at - this.age_limit_us)
    ) {
      this.bytes_ -= this.pictures[drop]!.bytes.byteLength;
      drop++;
    }
    if (drop > 0) this.pictures.splice(0, drop);
  }

  /** The newest picture at or before `at` (us); null when none is left. */
  at(at: number): {at: number; bytes: ArrayBuffer} | null {
    for (let i = this.pictures.length - 1; i >= 0; i--) {
      if (this.pictures[i]!.at <= at) return this.pictures[i]!;
    }
    return null;
  }

  /** The arrival (us) of the picture `by` steps from the one shown at `at`; null when there is none. */
  step(at: number, by: 1 | -1): number | null {
    if (by > 0) return this.pictures.find((picture) => picture.at > at)?.at ?? null;
    const shown = this.at(at);
    if (!shown) return null;
    const index = this.pictures.indexOf(shown);
    return this.pictures[index - 1]?.at ?? null;
  }

  forget(): void {
    this.pictures = [];
    this.bytes_ = 0;
  }
}
