import type {Desk, LeaseWord} from '../protocol.js';

type Holder = Desk['holder'];

/** How control went: another took it; it ran out; it was not granted, as another was first; the connection went. */
export type Loss = 'taken' | 'ended' | 'refused' | 'connection';

/** ms between two words that renew it. */
const kRenewal_ms = 1000;
/** ms after the last word: then mmi has ended it, and another word would quietly take it anew. */
const kLasts_ms = 5000;
/** ms after asking; until then what mmi tells may be of before. */
const kGranted_ms = 2000;

/** When to say what of the lease, and whether it is ours. All times are ms of performance.now(). */
export class LeaseKeeper {
  private wanted = false;
  private granted = false;
  private asked_ms = -Infinity;
  private said_ms = -Infinity;
  private holder: Holder = 'none';
  /** Why it is no longer ours; null: it is, or we did not want it. */
  loss: Loss | null = null;

  get holds(): boolean {
    return this.wanted && this.holder === 'you';
  }

  /** `take`: also from another. */
  ask(take: boolean, at_ms: number): LeaseWord {
    this.wanted = true;
    this.granted = this.holder === 'you';
    this.loss = null;
    this.asked_ms = this.said_ms = at_ms;
    return {type: 'lease', on: true, take};
  }

  giveUp(): LeaseWord {
    this.wanted = false;
    this.loss = null;
    return {type: 'lease', on: false};
  }

  /** mmi tells who holds it. */
  observe(holder: Holder, at_ms: number): void {
    this.holder = holder;
    if (!this.wanted) return;
    if (holder === 'you') this.granted = true;
    else if (this.granted && holder === 'another') this.lose('taken');
    else if (this.granted && at_ms - this.asked_ms > kGranted_ms) this.lose('ended');
  }

  /** What was held or asked for went with the conversation. */
  disconnect(): void {
    if (this.wanted) this.lose('connection');
    this.holder = 'none';
  }

  /** What to say now, or null. A page that is not `visible` says nothing: nobody looks at it. */
  step(at_ms: number, visible: boolean): LeaseWord | null {
    if (!this.wanted) return null;
    if (this.holder !== 'you') {
      if (at_ms - this.asked_ms > kGranted_ms) this.lose(this.granted ? 'ended' : 'refused');
      return null;
    }
    if (at_ms - this.said_ms > kLasts_ms) {
      this.lose('ended');
      return null;
    }
    if (!visible || at_ms - this.said_ms < kRenewal_ms) return null;
    this.said_ms = at_ms;
    return {type: 'lease', on: true};
  }

  private lose(how: Loss): void {
    this.wanted = false;
    this.loss = how;
  }
}
