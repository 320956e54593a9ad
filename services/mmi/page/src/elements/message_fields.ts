import {html, type TemplateResult} from 'lit';
import {plain, unitOfField, clock} from '../format.js';
import {isPlottable, leaves, type Leaf} from '../leaves.js';
import {addCurve, hasCurve} from '../curves.js';
import {store} from '../session.js';
import {stateName} from '../words.js';
import './choice.js';
import {StoreElement} from './store_element.js';

const kFieldsAtMost = 300;

/** All fields of a channel's newest message; a click plots a number. */
export class MessageFields extends StoreElement {
  static override properties = {channel: {type: String}};
  declare channel: string;
  private key = '';

  constructor() {
    super();
    this.channel = '';
    this.pace_ms = 200;
    this.shows = ['choice', 'state'];
  }

  protected override render(): TemplateResult {
    if (!this.channel) return html`<p class="empty">Choose a channel to see its fields</p>`;
    const slots = store.moment.slots(this.channel);
    const slot = slots.find((one) => one.key === this.key) ?? slots[0];
    if (!slot) return html`<p class="empty">Nothing heard on ${this.channel} yet</p>`;
    const all = slot.message ? leaves(slot.message) : [];
    return html` <p class="fields-head">
        <b>${this.channel}</b> at ${clock(slot.at)}
        ${
          slots.length > 1
            ? html`<mmi-choice
                label="Which of ${this.channel}"
                .offers=${slots.map(({key}) => ({value: key, words: key || '(one)'}))}
                .chosen=${slot.key}
                .choose=${this.onKey}
              ></mmi-choice>`
            : slot.key
        }
      </p>
      ${slot.bad ? html`<p class="reason">▲ Not a message: ${slot.bad}</p>` : ''}
      <div class="scroll" tabindex="0" aria-label="Fields of ${this.channel}">
        <table class="fields">
          <tbody>
            ${all.slice(0, kFieldsAtMost).map((leaf) => this.renderLeaf(leaf, slot.key))}
          </tbody>
        </table>
        ${all.length > kFieldsAtMost ? html`<p class="muted">and ${all.length - kFieldsAtMost} more</p>` : ''}
      </div>`;
  }

  private renderLeaf(leaf: Leaf, key: string): TemplateResult {
    const {unit, factor} = unitOfField(leaf.path);
    const named = leaf.path === 'state' ? stateName(store.hello, this.channel, leaf.value) : null;
    const text =
      named ?? (typeof leaf.value === 'number' ? `${plain(leaf.value * factor)} ${unit}` : String(leaf.value ?? '–'));
    const curve = {channel: this.channel, key, path: leaf.path};
    return html`<tr>
      <th scope="row">${leaf.path}</th>
      <td>${text}</td>
      <td class="number">
        ${
          isPlottable(leaf)
            ? html`<button
                class="row-button"
                aria-label="Plot ${leaf.path}"
                aria-pressed=${hasCurve(curve)}
                title="Plot in Log"
                @click=${() => addCurve(curve)}
              >
                ${hasCurve(curve) ? '✓ plotted' : 'plot'}
              </button>`
            : ''
        }
      </td>
    </tr>`;
  }

  private readonly onKey = (key: string): void => {
    this.key = key;
    this.requestUpdate();
  };
}
customElements.define('mmi-fields', MessageFields);
