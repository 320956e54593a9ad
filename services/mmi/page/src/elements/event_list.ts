import {html, nothing, type TemplateResult} from 'lit';
import {repeat} from 'lit/directives/repeat.js';
import {kRowsAtATime, rowsOf, wordsOf, type EventRows} from '../event_rows.js';
import {clock, microseconds} from '../format.js';
import type {RobotEvent} from '../protocol.js';
import {store} from '../session.js';
import {goTo} from '../transport.js';
import {kLevelSymbols} from '../words.js';
import './choice.js';
import {StoreElement} from './store_element.js';

/** Changes of state, the newest on top; a click goes to its time. */
export class EventList extends StoreElement {
  private only = '';
  private at_most = kRowsAtATime;
  private followed: string | null = null;

  constructor() {
    super();
    this.pace_ms = 250;
    this.shows = ['choice', 'state', 'events'];
  }

  protected override render(): TemplateResult {
    const chosen = (events: RobotEvent[]): RobotEvent[] =>
      this.only ? events.filter((event) => event.kind === this.only) : events;
    const until_now = chosen(store.events_shown);
    const current = until_now[until_now.length - 1]?.number ?? null;
    const kinds = [...new Set(store.events.map((event) => event.kind))].sort();
    const shown = rowsOf(store.is_log ? chosen(store.events) : until_now, this.at_most, current);
    return html` <mmi-choice
        class="kinds"
        label="Kind of events"
        .offers=${['', ...kinds].map((kind) => ({value: kind, words: kind || 'all kinds'}))}
        .chosen=${this.only}
        .choose=${this.onKind}
      ></mmi-choice>
      <ol
        class="events scroll"
        tabindex="0"
        aria-label="Events, newest first; arrows go from one to the next"
        @keydown=${this.onArrow}
      >
        ${this.renderLeftOut(shown)}
        ${repeat(
          shown.rows,
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

  /** On top, where it is seen at once. */
  private renderLeftOut(shown: EventRows): TemplateResult | typeof nothing {
    const words = wordsOf(shown, store.events_forgotten);
    if (words === '') return nothing;
    const more = shown.later > 0 ? 'show more' : 'show earlier';
    return html`<li>
      ${
        shown.earlier + shown.later > 0
          ? html`<button tabindex="-1" @click=${this.onMore}>
              <span></span><span>${more}</span><span class="muted">${words}</span>
            </button>`
          : html`<span class="muted">${words}</span>`
      }
    </li>`;
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

  private readonly onMore = (): void => {
    this.at_most += kRowsAtATime;
    this.requestUpdate();
  };

  private readonly onKind = (kind: string): void => {
    this.only = kind;
    this.at_most = kRowsAtATime;
    this.requestUpdate();
  };
}
customElements.define('mmi-events', EventList);
