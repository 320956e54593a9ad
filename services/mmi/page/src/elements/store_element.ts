import {LitElement} from 'lit';
import type {Change} from '../store.js';
import {store} from '../session.js';

const kAtOnce: Change[] = ['choice', 'picture', 'cursor', 'operate'];

/** An element that is redrawn when what it shows has changed; it is styled by app.css. */
export class StoreElement extends LitElement {
  /** ms between two redraws for what only comes along; what someone has chosen is drawn at once. */
  protected pace_ms = 60;
  /** Changes that it shows. */
  protected shows: Change[] = ['choice', 'state', 'events'];
  private drawn_ms = -Infinity;
  private timer: number | undefined;
  private stop_hearing: (() => void) | undefined;

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.stop_hearing = store.hear((change) => this.onChange(change));
    this.requestUpdate();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.stop_hearing?.();
    clearTimeout(this.timer);
    this.timer = undefined;
  }

  private onChange(change: Change): void {
    if (!this.shows.includes(change)) return;
    if (kAtOnce.includes(change)) {
      this.redraw();
      return;
    }
    const wait_ms = this.drawn_ms + this.pace_ms - performance.now();
    if (wait_ms <= 0) this.redraw();
    else this.timer ??= setTimeout(() => this.redraw(), wait_ms) as unknown as number;
  }

  private redraw(): void {
    clearTimeout(this.timer);
    this.timer = undefined;
    this.drawn_ms = performance.now();
    this.requestUpdate();
  }
}
