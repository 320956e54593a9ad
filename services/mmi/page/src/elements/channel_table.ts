import {html, type TemplateResult} from 'lit';
import {repeat} from 'lit/directives/repeat.js';
import {bytes, hertz, span} from '../format.js';
import type {ChannelFigures, ChannelRow} from '../protocol.js';
import {store} from '../session.js';
import {StoreElement} from './store_element.js';

/** All channels: how often, how old, how much is lost, who writes. */
export class ChannelTable extends StoreElement {
  static override properties = {chosen: {type: String}, choose: {attribute: false}};
  declare chosen: string;
  declare choose: (channel: string) => void;

  constructor() {
    super();
    this.chosen = '';
    this.choose = () => {};
    this.pace_ms = 250;
    this.shows = ['choice', 'state'];
  }

  protected override render(): TemplateResult {
    const figures = store.moment.part('figures') ?? {};
    const rows = store.hello?.channels ?? [];
    const known = new Set(rows.map((row) => row.name));
    const others = Object.keys(figures)
      .filter((name) => !known.has(name))
      .sort();
    const all = [...rows.map((row) => row.name), ...others];
    // What is heard comes first; a recording or a part of a stack leaves most of the table silent.
    const ordered = [...all.filter((name) => figures[name]), ...all.filter((name) => !figures[name])];
    const latency = store.moment.part('latency') ?? {};
    return html`<div class="scroll" tabindex="0" aria-label="Channels">
      <table>
        <thead>
          <tr>
            <th>channel</th>
            <th class="number">rate</th>
            <th class="number">age</th>
            <th class="number">lost</th>
            <th class="number">latency</th>
            <th class="number">writers</th>
            <th class="number traffic">traffic</th>
          </tr>
        </thead>
        <tbody>
          ${repeat(
            ordered,
            (name) => name,
            (name) =>
              this.renderRow(
                name,
                rows.find((row) => row.name === name),
                figures[name],
                latency[name] ?? null,
              ),
          )}
        </tbody>
      </table>
    </div>`;
  }

  private renderRow(
    name: string,
    row: ChannelRow | undefined,
    figure: ChannelFigures | undefined,
    latency: number | null,
  ): TemplateResult {
    const writers = Array.isArray(figure?.writers) ? figure.writers.length : figure?.writers;
    const lost = figure?.lost ?? null;
    const undecodable = figure?.undecodable ?? 0;
    const refused = figure?.refused ?? 0;
    return html`<tr class="${figure && !figure.stale ? '' : 'is-stale'} ${name === this.chosen ? 'is-selected' : ''}">
      <td>
        <button
          class="row-button"
          aria-pressed=${name === this.chosen}
          title=${row?.what ?? ''}
          @click=${() => this.choose(name)}
        >
          ${name}
        </button>
        ${row?.truth ? html`<span class="badge">truth</span>` : ''}
        ${refused > 0 ? html`<div class="refused">▲ ${refused} refused: ${figure?.refusal ?? ''}</div>` : ''}
      </td>
      <td class="number">${figure ? hertz(figure.hz) : 'silent'}</td>
      <td class="number">${figure?.stale ? '▲ ' : ''}${span(figure?.age_s)}</td>
      <td class="number">
        ${lost === null ? '–' : lost > 0 ? `▲ ${lost}` : '0'}${undecodable > 0 ? ` ▲ ${undecodable} bad` : ''}
      </td>
      <td class="number">${latency === null ? '' : span(latency)}</td>
      <td class="number">${writers === undefined ? '–' : writers > 1 ? `▲ ${writers}` : writers}</td>
      <td class="number traffic">${figure ? `${bytes(figure.bytes_per_second)}/s` : ''}</td>
    </tr>`;
  }
}
customElements.define('mmi-channels', ChannelTable);
