import {html, nothing, type TemplateResult} from 'lit';
import {icon} from '../drawing/icons.js';
import {microseconds, span} from '../format.js';
import type {Trouble} from '../protocol.js';
import {store} from '../session.js';
import {phaseOf, phaseWord, recordingWords} from '../words.js';
import {sinceOf} from '../task_time.js';
import {StoreElement} from './store_element.js';

/** Phases in which the robot has given its task up: no trouble of its own, and not well either. */
const kHalted = new Set(['REFUSED', 'FAILED', 'STOPPED']);
const kSymbols = {good: '✓', halted: '▲', unheard: '…'};
/** px: what Stop and its devices take of the page's width, and a letter of 28 px on average. */
const kBesideStop_px = 400;
const kLetter_px = 15.5;

/** In three lines of 28 px beside Stop. */
function lettersThatFit(): number {
  return (3 * (innerWidth - kBesideStop_px)) / kLetter_px;
}

/** What the robot does, what is worst, what mends it: of the present, even while the views show the past. */
export class StatusLine extends StoreElement {
  private ticking: number | undefined;

  constructor() {
    super();
    this.pace_ms = 100;
    this.shows = ['choice', 'state', 'events', 'picture'];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.ticking = setInterval(() => this.requestUpdate(), 250) as unknown as number;
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearInterval(this.ticking);
  }

  protected override render(): TemplateResult {
    const trouble = this.worst();
    const phase = phaseOf(store.hello, store.moment_live);
    const calm = phase === null ? 'unheard' : kHalted.has(phase) ? 'halted' : 'good';
    return html`
      <div class="status-facts">
        <span class="does">${this.renderTask(phase, trouble !== null)}</span>
        <span class="facts">${this.renderPicture()}${this.renderRecording()}</span>
      </div>
      <div
        role="status"
        aria-live="polite"
        class="trouble ${trouble ? 'is-bad' : `is-${calm}`}"
        data-trouble=${trouble?.code ?? 'none'}
        data-subject=${trouble?.subject ?? ''}
      >
        <span class="trouble-symbol" aria-hidden="true">${trouble ? '✖' : kSymbols[calm]}</span>
        ${trouble ? this.renderTrouble(trouble) : html`<span class="trouble-text">${this.calmWords(phase)}</span>`}
      </div>
    `;
  }

  private renderTrouble(trouble: Trouble): TemplateResult {
    const lost_for = trouble.code === 'mmi_lost' && store.life_why === '' ? this.lostFor() : '';
    const is_long = trouble.text.length + trouble.remedy.length > lettersThatFit();
    return html`<span class="trouble-text ${is_long ? 'is-long' : ''}"
      ><b>${trouble.text}</b>${lost_for ? html` <span aria-hidden="true">${lost_for}</span>` : nothing}
      ${trouble.remedy ? html`<span class="remedy">${trouble.remedy}</span>` : nothing}</span
    >`;
  }

  private worst(): Trouble | null {
    if (store.life !== 'open') return this.lost();
    const troubles = store.moment_live.part('troubles');
    return troubles?.[0] ?? null;
  }

  private lost(): Trouble {
    const seconds = (performance.now() - store.life_since_ms) / 1000;
    const refused = /token/i.test(store.life_why);
    const never = store.hello === null && store.life_why === '';
    return {
      code: 'mmi_lost',
      subject: 'mmi',
      since_utime: 0,
      text: refused
        ? 'This page has no token; Stop works without.'
        : never && seconds < 2
          ? 'Connecting to the robot.'
          : `No connection to mmi${store.life_why ? `: ${store.life_why}` : '.'}`,
      remedy: refused
        ? 'Open the address that scripts/page prints.'
        : 'The page comes back by itself; else scripts/stack status, and scripts/task stop to stop.',
    };
  }

  /** Not for screen readers: they would read it anew every second. */
  private lostFor(): string {
    return `${Math.max(1, Math.floor((performance.now() - store.life_since_ms) / 1000))} s`;
  }

  private calmWords(phase: string | null): string {
    if (phase === null) return store.hello ? 'Nothing heard of a task yet: scripts/stack status shows what runs' : '';
    const words = store.moment_live.message('TASK_STATE')?.reason || phaseWord(phase);
    return kHalted.has(phase) ? words : `all well${words ? `: ${words}` : ''}`;
  }

  /** With trouble below, the reason that would stand there stands here. */
  private renderTask(phase: string | null, with_reason: boolean): TemplateResult {
    if (phase === null) return html`<b>${store.hello ? 'No task heard of' : '–'}</b>`;
    const lost = store.life !== 'open';
    const task = store.moment_live.message('TASK_STATE');
    const since = sinceOf(store.events_until_now, phase);
    const seconds = since === null ? null : (store.moment_live.now - since) / 1e6;
    const details = [
      task.target,
      task.attempt > 1 ? `attempt ${task.attempt}` : '',
      seconds !== null && seconds >= 0 && !lost ? span(seconds) : '',
      with_reason ? task.reason : '',
    ];
    return html`${lost ? html`<span class="details">last heard: </span>` : nothing}<b>${phase}</b>
      <span class="details">${details.filter(Boolean).join(' · ')}</span>`;
  }

  private renderPicture(): TemplateResult {
    const age = store.life === 'open' ? this.pictureAge() : null;
    const words =
      age === null
        ? store.life === 'open'
          ? 'no picture'
          : 'picture of unknown age'
        : `picture ${span(Math.max(0, age))} old`;
    return html`<span class="fact">${words}</span>`;
  }

  /** s; of what is drawn, or, in a view without images and in the past, of the newest on the bus. */
  private pictureAge(): number | null {
    if (store.paused_at === null && document.querySelector('mmi-image') !== null) {
      return store.picture ? (store.moment_live.now - microseconds(store.picture.header.at)) / 1e6 : null;
    }
    return store.moment_live.part('figures')?.['STEREO_FRAME']?.age_s ?? null;
  }

  private renderRecording(): TemplateResult {
    if (store.is_log) return html`<span class="fact">from a log</span>`;
    const {on, text} = recordingWords(store.moment_live);
    return html`<span class="fact ${on ? 'is-on' : ''}">${on ? icon('record') : '○'} ${text}</span>`;
  }
}
customElements.define('mmi-status', StatusLine);
