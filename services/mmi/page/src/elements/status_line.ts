import {html, nothing, type TemplateResult} from 'lit';
import {icon} from '../drawing/icons.js';
import {microseconds, span} from '../format.js';
import type {Trouble} from '../protocol.js';
import {store} from '../session.js';
import {phaseOf, phaseWord, recordingWords} from '../words.js';
import {shortened, withSubject} from '../status_text.js';
import {sinceOf} from '../task_time.js';
import {StoreElement} from './store_element.js';

/** Phases in which the robot has given its task up: no trouble of its own, and not well either. */
const kHalted = new Set(['REFUSED', 'FAILED', 'STOPPED']);
const kSymbols = {good: '✓', halted: '▲', unheard: '…'};
/** Lines of 28 px that the header has room for. */
const kLinesAtMost = 3;

/** What stands beside the symbol: the explanation, of which as much as fits, and what mends it, whole. */
interface Said {
  subject: string;
  text: string;
  remedy: string;
  /** What goes on counting behind the text. */
  lost_for: string;
}

/** What the robot does, what is worst, what mends it: of the present, even while the views show the past. */
export class StatusLine extends StoreElement {
  private ticking: number | undefined;
  private readonly resizing = new ResizeObserver(() => this.onSize());
  private said: Said = {subject: '', text: '', remedy: '', lost_for: ''};
  /** What of the text fits, and of what and in which width. */
  private fitted = {of: '', text: ''};
  private width_px = 0;

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
    this.resizing.disconnect();
  }

  protected override firstUpdated(): void {
    this.resizing.observe(this);
  }

  /** Before the browser paints: cuts what has no room. */
  protected override updated(): void {
    const of = this.fittingKey();
    if (this.fitted.of === of) return;
    this.fitted = {of, text: this.fit()};
    if (this.fitted.text !== this.said.text) this.requestUpdate();
  }

  protected override render(): TemplateResult {
    const trouble = this.worst();
    const phase = phaseOf(store.hello, store.moment_live);
    const calm = phase === null ? 'unheard' : kHalted.has(phase) ? 'halted' : 'good';
    this.said = trouble
      ? {
          subject: trouble.subject,
          text: withSubject(trouble.text, trouble.subject),
          remedy: trouble.remedy,
          lost_for: trouble.code === 'mmi_lost' && store.life_why === '' ? this.lostFor() : '',
        }
      : {subject: '', text: this.calmWords(phase), remedy: '', lost_for: ''};
    return html`
      <div class="status-facts">
        ${this.renderTask(phase, trouble !== null)}
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
        ${this.renderSaid(trouble !== null)}
      </div>
    `;
  }

  /** What is cut can be read whole by pointing at it, and is what a screen reader says. */
  private renderSaid(is_trouble: boolean): TemplateResult {
    const {text, remedy, lost_for} = this.said;
    const shown = this.fitted.of === this.fittingKey() ? this.fitted.text : text;
    const whole = remedy ? `${text} → ${remedy}` : text;
    const is_cut = shown !== text;
    const said = is_trouble ? html`<b class="said">${shown}</b>` : html`<span class="said">${shown}</span>`;
    return html`<span class="trouble-text" title=${whole} aria-hidden=${is_cut ? 'true' : 'false'}
        >${said}${lost_for ? html` <span aria-hidden="true">${lost_for}</span>` : nothing}
        ${remedy ? html`<span class="remedy">${remedy}</span>` : nothing}</span
      >${is_cut ? html`<span class="visually-hidden">${whole}</span>` : nothing}`;
  }

  private onSize(): void {
    this.width_px = this.clientWidth;
    this.requestUpdate();
  }

  private fittingKey(): string {
    const {subject, text, remedy, lost_for} = this.said;
    return [subject, text, remedy, lost_for.length, this.width_px].join('\n');
  }

  /** As much of the text as stands in the lines with all of the remedy, as the browser breaks them. */
  private fit(): string {
    const shown = this.querySelector<HTMLElement>('.trouble-text')!;
    const trial = shown.cloneNode(true) as HTMLElement;
    trial.classList.add('is-trial');
    trial.style.setProperty('width', `${shown.getBoundingClientRect().width}px`);
    shown.parentElement!.after(trial);
    const said = trial.querySelector('.said')!;
    const height_at_most = kLinesAtMost * parseFloat(getComputedStyle(trial).lineHeight) + 1;
    const text = shortened(this.said.text, this.said.subject, (shorter) => {
      said.textContent = shorter;
      return trial.getBoundingClientRect().height <= height_at_most;
    });
    trial.remove();
    return text;
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
        ? 'mmi wants a token that this page has not; Stop works without.'
        : never && seconds < 2
          ? 'Connecting to mmi.'
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
    if (phase === null) return html`<span class="does"><b>${store.hello ? 'No task heard of' : '–'}</b></span>`;
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
    const words = details.filter(Boolean).join(' · ');
    return html`<span class="does" title="${phase} ${words}"
      >${lost ? html`<span class="details">last heard: </span>` : nothing}<b>${phase}</b>
      <span class="details">${words}</span></span
    >`;
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
