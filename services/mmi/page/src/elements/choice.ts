import {html, LitElement, render, type PropertyValues, type TemplateResult} from 'lit';
import {afterKey, type AfterKey} from '../choice_keys.js';

/** One of what a list offers. */
export interface Offer {
  value: string;
  words: string;
}

/** px, between the box and its list. */
const kGap_px = 2;

let lists = 0;

/**
 * One of some. The browser's own lists keep Escape to themselves while they are open: they would keep it from Stop. The
 * focus stays on the box.
 */
export class Choice extends LitElement {
  static override properties = {
    label: {type: String},
    offers: {attribute: false},
    chosen: {type: String},
    choose: {attribute: false},
    open: {state: true},
    offered: {state: true},
  };
  declare label: string;
  declare offers: Offer[];
  declare chosen: string;
  declare choose: (value: string) => void;
  declare private open: boolean;
  /** Index of what the keys are on. */
  declare private offered: number;
  private readonly id_of_list = `choice-${++lists}`;
  /** Outside of all panels, which would clip the list. */
  private readonly holder = document.createElement('div');

  constructor() {
    super();
    this.label = '';
    this.offers = [];
    this.chosen = '';
    this.choose = () => undefined;
    this.open = false;
    this.offered = 0;
  }

  protected override createRenderRoot(): HTMLElement {
    return this;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    document.body.append(this.holder);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.holder.remove();
    this.open = false;
  }

  protected override render(): TemplateResult {
    const offered = this.open ? `${this.id_of_list}-${this.offered}` : '';
    return html`<div
        class="choice-box"
        role="combobox"
        tabindex="0"
        aria-haspopup="listbox"
        aria-expanded=${this.open}
        aria-controls=${this.id_of_list}
        aria-activedescendant=${offered}
        aria-label=${this.label}
        title=${this.label}
        @click=${() => this.show(!this.open)}
        @keydown=${this.onKey}
        @blur=${() => this.show(false)}
      >
        <span>${this.offers[this.chosenIndex()]?.words ?? ''}</span><span aria-hidden="true">▾</span>
      </div>`;
  }

  private renderList(): TemplateResult {
    return html`<ul
      class="choice-list"
      role="listbox"
      id=${this.id_of_list}
      aria-label=${this.label}
      ?hidden=${!this.open}
      @mousedown=${(event: Event) => event.preventDefault()}
    >
      ${this.offers.map(
        (offer, index) =>
          html`<li
            role="option"
            id="${this.id_of_list}-${index}"
            class=${this.open && index === this.offered ? 'is-offered' : ''}
            aria-selected=${offer.value === this.chosen}
            @click=${() => this.take(index)}
          >
            ${offer.words}
          </li>`,
      )}
    </ul>`;
  }

  protected override updated(changed: PropertyValues): void {
    render(this.renderList(), this.holder);
    if (!this.open) return;
    const list = this.holder.querySelector<HTMLElement>('.choice-list')!;
    if (changed.has('open')) this.place(list);
    list.children[this.offered]?.scrollIntoView({block: 'nearest'});
  }

  /** Below the box, or above where there is more room. */
  private place(list: HTMLElement): void {
    const box = this.querySelector('.choice-box')!.getBoundingClientRect();
    const [above, below] = [box.top, innerHeight - box.bottom];
    const is_below = below >= above || below >= list.offsetHeight + kGap_px;
    list.style.setProperty('max-height', `${Math.max(above, below) - 2 * kGap_px}px`);
    list.style.setProperty('min-width', `${box.width}px`);
    list.style.setProperty('left', `${Math.max(0, Math.min(box.left, innerWidth - list.offsetWidth))}px`);
    list.style.setProperty('top', is_below ? `${box.bottom + kGap_px}px` : 'auto');
    list.style.setProperty('bottom', is_below ? 'auto' : `${innerHeight - box.top + kGap_px}px`);
  }

  private chosenIndex(): number {
    return Math.max(
      0,
      this.offers.findIndex((offer) => offer.value === this.chosen),
    );
  }

  private show(open: boolean): void {
    if (open === this.open) return;
    this.open = open;
    this.offered = this.chosenIndex();
  }

  private take(index: number): void {
    this.show(false);
    const offer = this.offers[index];
    if (offer && offer.value !== this.chosen) this.choose(offer.value);
  }

  private readonly onKey = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey) return;
    const offered = this.open ? this.offered : this.chosenIndex();
    const after = afterKey({open: this.open, offered}, event.key, this.offers.length);
    if (!after) return;
    if (after.taken) event.preventDefault();
    this.obey(after);
  };

  private obey(after: AfterKey): void {
    if (after.chooses) this.take(after.offered);
    else {
      this.open = after.open;
      this.offered = after.offered;
    }
  }
}
customElements.define('mmi-choice', Choice);
