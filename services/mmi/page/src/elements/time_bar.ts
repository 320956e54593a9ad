import {html, svg, nothing, type TemplateResult} from 'lit';
import {live as held} from 'lit/directives/live.js';
import {icon} from '../drawing/icons.js';
import {clock, microseconds, span} from '../format.js';
import type {RobotEvent} from '../protocol.js';
import {store} from '../session.js';
import {
  chosenSpeed,
  goTo,
  goToEvent,
  playOrPause,
  plays,
  range,
  setSpeed,
  showNewest,
  shownTime,
  soughtTime,
  step,
} from '../transport.js';
import {kLevelSymbols} from '../words.js';
import './choice.js';
import {StoreElement} from './store_element.js';

const kSpeedOffers = [0.1, 0.25, 0.5, 1, 2, 5, 10].map((speed) => ({value: String(speed), words: `${speed} ×`}));
/** us, what an arrow key moves the time by, and with Shift. */
const kKeyStep_us = 1e6;
const kLongKeyStep_us = 10e6;
/** Places of the thumb. */
const kThumbSteps = 1e6;
/** Ticks that fall on the same thousandth of the line are one. */
const kTickPlaces = 1000;

/** Time: of a log from end to end, or of what the page remembers; events are ticks on it. */
export class TimeBar extends StoreElement {
  /** us, where the thumb is while it is dragged. */
  private dragged: number | null = null;
  private ticks: {of: RobotEvent[]; begin: number; end: number; places: [number, RobotEvent][]} | null = null;

  constructor() {
    super();
    this.pace_ms = 100;
    this.shows = ['choice', 'cursor', 'state', 'events'];
  }

  protected override render(): TemplateResult {
    const {begin, end} = range();
    const at = shownTime();
    const thumb = this.dragged ?? soughtTime() ?? at;
    const log = store.is_log;
    const live = !log && store.paused_at === null;
    const words = log
      ? `${span((at - begin) / 1e6)} of ${span((end - begin) / 1e6)}`
      : live
        ? 'now'
        : `${span((end - at) / 1e6)} ago`;
    return html`
      <div class="transport" role="group" aria-label="Time">
        <button @click=${() => goToEvent(-1)} title="Previous event (P)" aria-label="Previous event">
          ${icon('previous')}
        </button>
        <button @click=${() => step(-1)} title="One picture back (,)" aria-label="One picture back">
          ${icon('back')}
        </button>
        <button
          class="play"
          @click=${playOrPause}
          title="${plays() ? 'Pause' : 'Play'} (K)"
          aria-label=${plays() ? 'Pause' : 'Play'}
        >
          ${icon(plays() ? 'pause' : 'play')}
        </button>
        <button @click=${() => step(1)} title="One picture on (.)" aria-label="One picture on">${icon('on')}</button>
        <button @click=${() => goToEvent(1)} title="Next event (N)" aria-label="Next event">${icon('next')}</button>
        ${
          log
            ? html`<mmi-choice
                label="Speed"
                .offers=${kSpeedOffers}
                .chosen=${String(chosenSpeed())}
                .choose=${this.onSpeed}
              ></mmi-choice>`
            : html`<button
                class="newest ${live ? 'is-on' : ''}"
                aria-pressed=${live}
                @click=${showNewest}
                title="The newest (L)"
              >
                ${live ? '● live' : '○ live'}
              </button>`
        }
      </div>
      <div class="line">
        ${this.renderTicks(store.events, begin, end, at)}
        <input
          type="range"
          min="0"
          max=${kThumbSteps}
          step="1"
          .value=${held(String(Math.round(position(thumb, begin, end) * kThumbSteps)))}
          aria-label="Time"
          aria-valuetext="${clock(at)} UTC, ${words}"
          @input=${this.onSlide}
          @change=${this.onSlideEnd}
          @keydown=${this.onKey}
        />
      </div>
      <output class="time ${live || log ? '' : 'is-past'}"
        ><b>${clock(at)}</b><span>${live || log ? '' : 'past, '}${words}</span></output
      >
    `;
  }

  private renderTicks(events: RobotEvent[], begin: number, end: number, at: number): TemplateResult {
    if (this.ticks?.of !== events || this.ticks.begin !== begin || this.ticks.end !== end) {
      this.ticks = {of: events, begin, end, places: ticksOf(events, begin, end)};
    }
    const marker = (value: number | null, name: string): unknown =>
      value === null || !Number.isFinite(value)
        ? nothing
        : svg`<line class=${name} x1=${position(value, begin, end) * kTickPlaces} x2=${position(value, begin, end) * kTickPlaces} y1="0" y2="24"></line>`;
    return html`<svg class="ticks" viewBox="0 0 ${kTickPlaces} 24" preserveAspectRatio="none" aria-hidden="true">
      ${this.ticks.places.map(
        ([
          x,
          event,
        ]) => svg`<line class="tick is-${event.level}" x1=${x} x2=${x} y1=${event.kind === 'task' ? 2 : 10} y2="24">
        <title>${clock(event.at)} ${kLevelSymbols[event.level]} ${event.text}</title></line>`,
      )}
      ${marker(store.cursor, 'cursor')}${marker(store.reference, 'reference')}${marker(at, 'at')}
    </svg>`;
  }

  private readonly onSpeed = (speed: string): void => setSpeed(Number(speed));

  private readonly onSlide = (event: Event): void => {
    const {begin, end} = range();
    this.dragged = begin + (Number((event.target as HTMLInputElement).value) / kThumbSteps) * (end - begin);
    goTo(this.dragged);
  };

  private readonly onSlideEnd = (): void => {
    this.dragged = null;
    this.requestUpdate();
  };

  private readonly onKey = (event: KeyboardEvent): void => {
    const by = {ArrowRight: 1, ArrowUp: 1, ArrowLeft: -1, ArrowDown: -1}[event.key];
    if (by === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    goTo((soughtTime() ?? shownTime()) + by * (event.shiftKey ? kLongKeyStep_us : kKeyStep_us));
    this.requestUpdate();
  };
}
customElements.define('mmi-time', TimeBar);

/** The gravest event of each place of the line. */
function ticksOf(events: RobotEvent[], begin: number, end: number): [number, RobotEvent][] {
  const places = new Map<number, RobotEvent>();
  const rank = {info: 0, good: 1, warning: 2, bad: 3};
  for (const event of events) {
    const place = position(microseconds(event.at), begin, end);
    if (place < 0 || place > 1) continue;
    const key = Math.round(place * kTickPlaces);
    const there = places.get(key);
    if (!there || rank[event.level] > rank[there.level]) places.set(key, event);
  }
  return [...places];
}

function position(at: number, begin: number, end: number): number {
  return end > begin && Number.isFinite(at) ? (at - begin) / (end - begin) : 1;
}
