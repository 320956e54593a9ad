import {html, nothing, type TemplateResult} from 'lit';
import {live} from 'lit/directives/live.js';
import type {Pose} from '../drawing/geometry.js';
import {clock} from '../format.js';
import {fateWords, type Commanded, type Fate} from '../operate/answer_list.js';
import {grouped} from '../operate/command_reasons.js';
import type {Loss} from '../operate/lease_keeper.js';
import {placeOf, placeWords, textsOf, type PlaceTexts} from '../operate/wished_place.js';
import type {CommandKind, Desk} from '../protocol.js';
import {operator, store} from '../session.js';
import {StoreElement} from './store_element.js';

const kFateSymbols: Record<Fate, string> = {
  waiting: '…',
  refused: '▲',
  sent: '…',
  under_way: '▶',
  done: '✓',
  failed: '✖',
  unanswered: '?',
};

const kControlWords: Record<Desk['holder'], string> = {
  none: 'take control',
  you: 'give up',
  another: 'take over from another',
};

const kLossWords: Record<Loss, string> = {
  taken: 'Another has taken control over: this page commands no more.',
  ended: 'Control has ended: this page was hidden, or not heard, for 5 s.',
  refused: 'Control was not granted: another was first.',
  connection: 'Control went with the connection to mmi.',
};

const kFields: {name: keyof PlaceTexts; words: string; unit: string; step: string}[] = [
  {name: 'x', words: 'x', unit: 'm', step: '0.01'},
  {name: 'y', words: 'y', unit: 'm', step: '0.01'},
  {name: 'heading', words: 'heading', unit: '°', step: '1'},
];

interface Button {
  /** Of a command, or `control`. */
  id: CommandKind | 'control';
  name: string;
  why: string;
}

/** Who commands the robot, what can be commanded, and what became of it. Always of the present, whatever is shown. */
export class OperatePanel extends StoreElement {
  static override properties = {places: {attribute: false}};
  /** With fields for the place to drive to. */
  declare places: boolean;
  /** What stands in the fields, and the place that it says; whoever else chooses a place writes them anew. */
  private typed: PlaceTexts = textsOf(null);
  private typed_place: Pose | null = null;

  constructor() {
    super();
    this.places = false;
    this.shows = ['choice', 'operate'];
  }

  protected override render(): TemplateResult {
    const control: Button = {id: 'control', name: kControlWords[operator.holder], why: operator.whyNoControl()};
    const commands = this.commands();
    return html`<div class="operate" data-operate=${operator.holder}>
      ${this.renderControl(control)}
      ${store.paused_at === null ? nothing : html`<p class="notice">▲ The past is shown: what is commanded is done now.</p>`}
      ${this.renderTargets()}
      <div class="operate-buttons" role="group" aria-label="Commands">
        ${commands.map((command) => this.renderCommand(command))}
      </div>
      ${this.places ? this.renderPlace() : nothing} ${this.renderReasons([control, ...commands])}
      ${this.renderAnswers()}
    </div>`;
  }

  private commands(): Button[] {
    const target = this.target();
    const names: Record<CommandKind, string> = {
      start: target ? `Start: ${target}` : 'Start',
      carry: 'Start and carry',
      drive: 'Drive here',
      home: 'Home',
      abort: 'Abort',
      reset: 'Reset',
    };
    return (Object.keys(names) as CommandKind[]).map((id) => ({
      id,
      name: names[id],
      why: operator.whyNot(id, store.selected),
    }));
  }

  private target(): string | null {
    return operator.desk?.targets.includes(store.selected ?? '') ? store.selected : null;
  }

  private renderControl({name, why}: Button): TemplateResult {
    const {holder, loss, desk} = operator;
    const since = ` since ${clock(desk?.since).slice(0, 8)} UTC`;
    const who = {none: 'Nobody operates', you: `You operate${since}`, another: `Another operates${since}`}[holder];
    return html`<div class="operate-who">
        <p><b>${who}.</b> <span class="muted">A task goes on when this page is lost.</span></p>
        <button
          data-control
          data-can=${why === '' ? 'yes' : 'no'}
          aria-disabled=${why !== ''}
          aria-describedby=${why === '' ? nothing : 'why-control'}
          @click=${() => operator.toggleControl(performance.now())}
        >
          ${name}
        </button>
      </div>
      <p class="notice" role="status" ?hidden=${loss === null} data-loss=${loss ?? 'none'}>
        ${loss === null ? '' : `▲ ${kLossWords[loss]}`}
      </p>`;
  }

  private renderTargets(): TemplateResult {
    const marks = store.hello?.scene.marks ?? [];
    return html`<div class="operate-targets" role="group" aria-label="Target">
      ${(operator.desk?.targets ?? []).map(
        (name) =>
          html`<button data-target=${name} aria-pressed=${store.selected === name} @click=${() => store.select(name)}>
            <svg viewBox="0 0 10 10" aria-hidden="true">
              <rect width="10" height="10" fill=${marks.find((mark) => mark.name === name)?.colour ?? '#888888'}></rect>
            </svg>
            ${name}
          </button>`,
      )}
    </div>`;
  }

  private renderCommand({id, name, why}: Button): TemplateResult {
    const kind = id as CommandKind;
    const place = kind === 'drive' && operator.wished ? html`<small>${placeWords(operator.wished)}</small>` : nothing;
    return html`<button
      data-command=${kind}
      data-can=${why === '' ? 'yes' : 'no'}
      aria-disabled=${why !== ''}
      aria-describedby=${why === '' ? nothing : `why-${kind}`}
      @click=${() => operator.command(kind, store.selected, performance.now())}
    >
      ${name}${place}
    </button>`;
  }

  private renderPlace(): TemplateResult {
    if (operator.wished !== this.typed_place) {
      this.typed_place = operator.wished;
      this.typed = textsOf(operator.wished);
    }
    return html`<div class="operate-place" role="group" aria-label="Place to drive to">
      ${kFields.map(
        ({name, words, unit, step}) =>
          html`<label
            >${words}<input
              type="number"
              step=${step}
              data-place-field=${name}
              .value=${live(this.typed[name])}
              @input=${(event: InputEvent) => this.onTyped(name, (event.target as HTMLInputElement).value)}
            />${unit}</label
          >`,
      )}
    </div>`;
  }

  private onTyped(name: keyof PlaceTexts, text: string): void {
    this.typed = {...this.typed, [name]: text};
    this.typed_place = placeOf(this.typed);
    operator.wish(this.typed_place);
  }

  private renderReasons(buttons: Button[]): TemplateResult | typeof nothing {
    const groups = grouped(buttons);
    if (groups.length === 0) return nothing;
    return html`<ul class="operate-whys" aria-label="What does not work now, and why">
      ${groups.map(({why, names}) => {
        const all = names.length >= buttons.length - 1;
        return html`<li>
          ${buttons.filter((button) => button.why === why).map(({id}) => html`<span id="why-${id}" hidden>${why}</span>`)}
          ${all ? '' : html`<b>${names.join(', ')}</b>: `}${why}
        </li>`;
      })}
    </ul>`;
  }

  private renderAnswers(): TemplateResult {
    const {entries} = operator.answers;
    const newest = entries[0];
    return html`<p class="visually-hidden" role="status">
        ${newest ? `${newest.words}: ${fateWords(newest)}` : ''}
      </p>
      <ol class="answers" aria-label="What was commanded, the newest first">
        ${entries.map((entry) => this.renderAnswer(entry))}
      </ol>`;
  }

  private renderAnswer(entry: Commanded): TemplateResult {
    return html`<li data-answer=${entry.seq} data-state=${entry.fate} data-kind=${entry.kind} data-code=${entry.code}>
      <span aria-hidden="true">${kFateSymbols[entry.fate]}</span>
      <span><b>${entry.words}</b>: ${fateWords(entry)}</span>
    </li>`;
  }
}
customElements.define('mmi-operate', OperatePanel);
