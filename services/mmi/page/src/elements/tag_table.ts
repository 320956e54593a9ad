import {html, type TemplateResult} from 'lit';
import {repeat} from 'lit/directives/repeat.js';
import {metres, span} from '../format.js';
import {arrivalOf, TagMemory} from '../tag_memory.js';
import {store} from '../session.js';
import {StoreElement} from './store_element.js';

const kSymbols = {read: '●', missed: '✕', expected: '○', unexpected: '◆', idle: '·'};

/** Tags that have been read or missed lately, the newest on top. */
export class TagTable extends StoreElement {
  private readonly memory = new TagMemory();

  constructor() {
    super();
    this.pace_ms = 200;
    this.shows = ['choice', 'state'];
  }

  protected override render(): TemplateResult {
    const moment = store.moment;
    const floor = moment.part('floor');
    const arrival = arrivalOf(floor, moment.slot('RFID_TAG_HITS'), moment.now);
    this.memory.observe(floor, store.hello?.scene.tags ?? [], arrival);
    const rows = this.memory.rows(moment.now);
    return html`<div class="scroll" tabindex="0" aria-label="Tags">
      <table>
        <thead>
          <tr>
            <th>tag</th>
            <th>state</th>
            <th class="number">place</th>
            <th class="number">RSSI</th>
            <th class="number">age</th>
            <th class="number">count</th>
          </tr>
        </thead>
        <tbody>
          ${repeat(
            rows,
            (row) => row.uid,
            (row) =>
              html` <tr class=${store.selected === row.uid ? 'is-selected' : ''}>
                <td>
                  <button
                    class="row-button"
                    aria-pressed=${store.selected === row.uid}
                    @click=${() => store.select(row.uid)}
                  >
                    ${row.uid}
                  </button>
                </td>
                <td>${kSymbols[row.state]} ${row.state}</td>
                <td class="number">
                  ${row.place ? `${row.place[0].toFixed(2)}, ${metres(row.place[1], 2)}` : 'unknown'}
                </td>
                <td class="number">${row.rssi === null ? '–' : `${row.rssi.toFixed(1)} dBm`}</td>
                <td class="number">${span((moment.now - row.at) / 1e6)}</td>
                <td class="number">${row.count}</td>
              </tr>`,
          )}
        </tbody>
      </table>
      ${rows.length === 0 ? html`<p class="empty">No tag read yet</p>` : ''}
    </div>`;
  }
}
customElements.define('mmi-tags', TagTable);
