/** mmi's clock, as its newest update tells it: never ahead of it, and behind by as long as that update took to come. */
export class MmiClock {
  private newest: {now_us: number; came_ms: number} | null = null;

  /** An update came that said `now_us`; `came_ms`: of performance.now(). */
  observe(now_us: number, came_ms: number): void {
    if (Number.isFinite(now_us)) this.newest = {now_us, came_ms};
  }

  forget(): void {
    this.newest = null;
  }

  /** us at `at_ms` of performance.now(); null before the first update. */
  at(at_ms: number): number | null {
    return this.newest && this.newest.now_us + 1000 * (at_ms - this.newest.came_ms);
  }
}
