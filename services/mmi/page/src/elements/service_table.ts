import {html, type TemplateResult} from 'lit';
import {repeat} from 'lit/directives/repeat.js';
import {microseconds, span} from '../format.js';
import {joinServices, type ServiceRow} from '../services.js';
import {store} from '../session.js';
import {kLevelSymbols, stateName} from '../words.js';
import {StoreElement} from './store_element.js';

/** Each service with its process: what it says of itself, and whether it runs. */
export class ServiceTable extends StoreElement {
  constructor() {
    super();
    this.pace_ms = 250;
    this.shows = ['choice', 'state'];
  }

  protected override render(): TemplateResult {
    const moment = store.moment;
    const rows = joinServices(
      moment.slots('SERVICE_STATUS'),
      moment.slots('PROCESS_STATUS'),
      (state) => stateName(store.hello, 'PROCESS_STATUS', state),
      moment.now,
    );
    return html`<div class="scroll" tabindex="0" aria-label="Services">
      <table>
        <thead>
          <tr>
            <th>service</th>
            <th>says</th>
            <th class="number">age</th>
            <th>process</th>
            <th class="number">pid</th>
            <th class="number">restarts</th>
          </tr>
        </thead>
        <tbody>
          ${repeat(
            rows,
            (row) => row.key,
            (row) => this.renderRow(row),
          )}
        </tbody>
      </table>
      ${rows.length === 0 ? html`<p class="empty">No service heard yet</p>` : ''}
    </div>`;
  }

  private renderRow(row: ServiceRow): TemplateResult {
    const why = [row.reason, row.why].filter(Boolean).join('; ');
    return html`<tr class=${row.level === 'bad' ? 'is-stale' : ''}>
      <th scope="row" title=${row.key}>
        <span class="level is-${row.level}">${kLevelSymbols[row.level]}</span> ${row.name}
      </th>
      <td class="says" title=${why}>${row.state ?? (row.bad ? 'garbled' : 'silent')}${why ? html`<span class="muted"> ${why}</span>` : ''}</td>
      <td class="number">
        ${row.at === null ? '–' : span(Math.max(0, (store.moment.now - microseconds(row.at)) / 1e6))}
      </td>
      <td>${row.process ?? '–'}</td>
      <td class="number">${row.pid ?? '–'}</td>
      <td class="number">${row.restarts ?? '–'}</td>
    </tr>`;
  }
}
customElements.define('mmi-services', ServiceTable);
