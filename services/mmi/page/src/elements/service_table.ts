import {html, type TemplateResult} from 'lit';
import {repeat} from 'lit/directives/repeat.js';
import {bytes, clock, microseconds, span} from '../format.js';
import {recorderRows, type RecorderRow} from '../recorders.js';
import {joinServices, type ServiceRow} from '../services.js';
import {store} from '../session.js';
import {kLevelSymbols, stateName} from '../words.js';
import {StoreElement} from './store_element.js';

/** A time with its day, UTC. */
function dayAndClock(us: number): string {
  const day = clock(us) === '–' ? '' : new Date(us / 1000).toISOString().slice(0, 10);
  return `${day} ${clock(us)} UTC`;
}

/** Each service with its process: what it says of itself, and whether it runs; and the recorders. */
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
            <th class="number">began, UTC</th>
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
      ${this.renderRecorders(recorderRows(moment.slots('RECORDER_STATUS'), moment.now))}
    </div>`;
  }

  private renderRecorders(rows: RecorderRow[]): TemplateResult {
    if (rows.length === 0) return html`<p class="muted">No recorder heard yet</p>`;
    return html`<table>
      <thead>
        <tr>
          <th>recorder</th>
          <th>says</th>
          <th class="number">age</th>
          <th class="number">written</th>
          <th class="number">free</th>
          <th class="number">parts</th>
        </tr>
      </thead>
      <tbody>
        ${repeat(
          rows,
          (row) => row.key,
          (row) => this.renderRecorder(row),
        )}
      </tbody>
    </table>`;
  }

  private renderRecorder(row: RecorderRow): TemplateResult {
    const place = row.folder || row.key;
    return html`<tr class=${row.level === 'bad' ? 'is-stale' : ''}>
      <th scope="row" title="${row.host}:${place}">
        <span class="level is-${row.level}">${kLevelSymbols[row.level]}</span> ${place}
      </th>
      <td class="says" title=${row.why}>${row.words}${row.why ? html`<span class="muted"> ${row.why}</span>` : ''}</td>
      <td class="number">${this.age(row.at)}</td>
      <td class="number">${bytes(row.bytes)}</td>
      <td class="number">${bytes(row.free_bytes)}</td>
      <td class="number">${row.parts ?? '–'}</td>
    </tr>`;
  }

  private age(at: number | null): string {
    return at === null ? '–' : span(Math.max(0, (store.moment.now - microseconds(at)) / 1e6));
  }

  private renderRow(row: ServiceRow): TemplateResult {
    const why = [row.reason, row.why].filter(Boolean).join('; ');
    return html`<tr class=${row.level === 'bad' ? 'is-stale' : ''}>
      <th scope="row" title=${row.key}>
        <span class="level is-${row.level}">${kLevelSymbols[row.level]}</span> ${row.name}
      </th>
      <td class="says" title=${why}>${row.state ?? (row.bad ? 'garbled' : 'silent')}${why ? html`<span class="muted"> ${why}</span>` : ''}</td>
      <td class="number">${this.age(row.at)}</td>
      <td>${row.process ?? '–'}</td>
      <td class="number">${row.pid ?? '–'}</td>
      <td class="number" title=${row.started === null ? '' : dayAndClock(row.started)}>
        ${clock(row.started).slice(0, 8)}
      </td>
      <td class="number">${row.restarts ?? '–'}</td>
    </tr>`;
  }
}
customElements.define('mmi-services', ServiceTable);
