import {html, type TemplateResult} from 'lit';
import {repeat} from 'lit/directives/repeat.js';
import {clock, microseconds} from '../format.js';
import type {RobotEvent} from '../protocol.js';
import {store} from '../session.js';
import {goTo} from '../transport.js';
import {kLevelSymbols} from '../words.js';
import {StoreElement} from './store_element.js';

const kRowsAtMost = 1000;

/** Changes of state, the newest on top; a click goes to its time. */
export class EventList extends StoreElement {
  private only = '';
  private followed: string | null = null;

  constructor() {
    super();
    this.pace_ms = 250;
    this.shows = ['choice', 'state', 'events'];
  }

  protected override render(): TemplateResult {
    const all = store.is_log ? store.events : store.events_shown;
    const current = store.events_shown[store.events_shown.length - 1]?.number ?? null;
    const kinds = [...new Set(store.events.map((event) => event.kind))].sort();
    const rows = all
      .filter((event) => !this.only || event.kind === this.only)
      .slice(-kRowsAtMost)
      .reverse();
    return html` <select class="kinds" aria-label="Kind of events" @change=${this.onKind}>
        <option value="">all kinds</option>
        ${kinds.map((kind) => html`<option value=${kind} .selected=${kind === this.only}>${kind}</option>`)}
      </select>
      <ol
        class="events scroll"
        tabindex="0"
        aria-label="Events, newest first; arrows go from one to the next"
        @keydown=${this.onArrow}
      >
        ${repeat(
          rows,
          (event) => event.number,
          (event) => this.renderRow(event, store.is_log && event.number === current),
        )}
      </ol>`;
  }

  protected override updated(): void {
    const current = this.querySelector<HTMLElement>('[aria-current=true]');
    const number = current?.dataset['event'] ?? null;
    if (number === this.followed) return;
    this.followed = number;
    const list = this.querySelector('.events')!;
    if (current) list.scrollTop = current.offsetTop - list.clientHeight / 2;
  }

  private renderRow(event: RobotEvent, current: boolean): TemplateResult {
    return html`<li data-event=${event.number} aria-current=${current ? 'true' : 'false'}>
      <button
        tabindex="-1"
        @click=${() => goTo(microseconds(event.at))}
        title="${event.channel} ${event.key} ${clock(event.at)} UTC"
      >
        <span class="level is-${event.level}">${kLevelSymbols[event.level]}</span>
        <span class="event-time">${clock(event.at).slice(0, 8)}</span>
        <span class="event-text">${(event.text || event.state).replace('->', '→')}</span>
      </button>
    </li>`;
  }

  private readonly onArrow = (event: KeyboardEvent): void => {
    const by = {ArrowDown: 1, ArrowUp: -1}[event.key];
    if (by === undefined) return;
    event.preventDefault();
    const rows = [...this.querySelectorAll<HTMLElement>('.events button')];
    const index = rows.indexOf(document.activeElement as HTMLElement);
    rows[Math.min(rows.length - 1, Math.max(0, index + by))]?.focus();
  };

  private readonly onKind = (event: Event): void => {
    this.only = (event.target as HTMLSelectElement).value;
    this.requestUpdate();
  };
}
customElements.define('mmi-events', EventList);
