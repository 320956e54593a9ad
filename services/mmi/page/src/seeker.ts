/** ms; a seek that has brought nothing by then is given up. */
const kGivenUp_ms = 1000;

/** Lets one seek be under way at a time; of those wanted meanwhile only the newest is made. */
export class Seeker {
  private sent_ms: number | null = null;
  private under_way: number | null = null;
  private next: number | null = null;

  constructor(private readonly send: (at: number) => void) {}

  /** us; where it is going; null when it has arrived. */
  get target(): number | null {
    return this.next ?? this.under_way;
  }

  /** Goes to `at` (us), at once or when the last seek has come back; `now_ms`: of a clock that does not jump. */
  seek(at: number, now_ms: number): void {
    this.next = at;
    this.work(now_ms);
  }

  /** The source has gone where it was told to. */
  arrived(now_ms: number): void {
    this.under_way = null;
    this.work(now_ms);
  }

  /** Goes nowhere any more. */
  forget(): void {
    this.under_way = null;
    this.next = null;
  }

  /** To be called from time to time: gives up what has got lost. */
  work(now_ms: number): void {
    if (this.under_way !== null && now_ms - this.sent_ms! > kGivenUp_ms) this.under_way = null;
    if (this.under_way !== null || this.next === null) return;
    this.under_way = this.next;
    this.sent_ms = now_ms;
    this.next = null;
    this.send(this.under_way);
  }
}
