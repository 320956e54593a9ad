import {html, type TemplateResult} from 'lit';
import uPlot from 'uplot';
import {addCurve, curves, idOf, nameOf, valueOf, type Curve} from '../curves.js';
import {csvOf} from '../csv.js';
import {saveFile, savePng} from '../save.js';
import {clock, plain, span, unitOfField} from '../format.js';
import {lookAt} from '../look.js';
import type {Slot} from '../protocol.js';
import {store} from '../session.js';
import {goTo, range, shownTime} from '../transport.js';
import {addSample, joinCurves, nearestIndex, type Samples} from '../drawing/samples.js';
import {StoreElement} from './store_element.js';

const kColours = [
  '--curve-1',
  '--curve-2',
  '--curve-3',
  '--curve-4',
  '--curve-5',
  '--curve-6',
  '--curve-7',
  '--curve-8',
];
const kAxisUnit = 1e6;
const kZoomStep = 2;
/** us; less than a picture's time shows no curve. */
const kShortest_us = 20000;

/** Curves over the last minutes. One cursor goes through all views; a second one stays where it is set. */
export class Plots extends StoreElement {
  private plot: uPlot | null = null;
  private plotted = '';
  private read = new Map<string, Samples>();
  private zoom: {min: number; max: number} | null = null;
  private resizing: ResizeObserver | null = null;

  constructor() {
    super();
    this.pace_ms = 150;
    this.shows = ['choice', 'cursor', 'state'];
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.resizing?.disconnect();
    this.plot?.destroy();
    this.plot = null;
    this.plotted = '';
    lookAt('plots', []);
  }

  protected override render(): TemplateResult {
    const samples = this.samples();
    return html`
      <div class="plot-tools" role="group" aria-label="Plots">
        <button @click=${() => this.zoomBy(1 / kZoomStep)} aria-label="Less time" title="Less time">+</button>
        <button @click=${() => this.zoomBy(kZoomStep)} aria-label="More time" title="More time">−</button>
        <button class="whole" @click=${this.wholeTime} ?disabled=${this.zoom === null}>whole time</button>
        <button @click=${this.setReference} title="Differences are taken from here">set second cursor</button>
        <button @click=${() => store.setReference(null)} ?disabled=${store.reference === null}>clear it</button>
        <button @click=${this.saveCsv}>CSV</button><button @click=${this.savePlot}>PNG</button>
        <span class="muted">point for values, click to go there, drag to zoom</span>
      </div>
      <div class="plot" role="img" aria-label="Curves over time"></div>
      <div class="scroll curve-table" tabindex="0" aria-label="Values at the cursors">
        <table>
          <thead>
            <tr>
              <th>curve</th>
              <th class="number">at ${this.cursorWords()}</th>
              ${
                store.reference === null
                  ? html`<td></td>
                      <td></td>`
                  : html`<th class="number">at ${clock(store.reference)}</th>
                      <th class="number">difference</th>`
              }
              <td></td>
            </tr>
          </thead>
          <tbody>
            ${curves().map((curve, index) => this.renderValues(curve, index, samples[index]!))}
          </tbody>
        </table>
      </div>
    `;
  }

  protected override updated(): void {
    if (!this.isConnected) return;
    lookAt(
      'plots',
      curves().map((curve) => curve.channel),
    );
    const holder = this.querySelector<HTMLElement>('.plot')!;
    if (!this.resizing) {
      this.resizing = new ResizeObserver(() =>
        this.plot?.setSize({width: holder.clientWidth, height: holder.clientHeight}),
      );
      this.resizing.observe(holder);
    }
    const names = curves().map(nameOf).join('|') + getComputedStyle(document.documentElement).getPropertyValue('--ink');
    if (!this.plot || names !== this.plotted) {
      this.plot?.destroy();
      this.plot = new uPlot(this.options(holder), [[]], holder);
      this.plotted = names;
    }
    this.plot.batch(() => {
      this.plot!.setData(joinCurves(this.samples(), kAxisUnit) as uPlot.AlignedData, false);
      const {min, max} = this.window();
      this.plot!.setScale('x', {min: min / kAxisUnit, max: max / kAxisUnit});
    });
  }

  private window(): {min: number; max: number} {
    if (this.zoom) return this.zoom;
    if (store.is_log) return this.windowOfLog();
    const begin = store.history.begin ?? range().begin;
    return {min: begin, max: Math.max(store.now, begin + 1e6)};
  }

  /** What has been shown of it. */
  private windowOfLog(): {min: number; max: number} {
    const at = Number.isFinite(shownTime()) ? shownTime() : range().begin;
    const known = [...this.read.values()].filter((samples) => samples.at.length > 0);
    const min = Math.min(at, ...known.map((samples) => samples.at[0]!));
    return {min, max: Math.max(at, min + 1e6, ...known.map((samples) => samples.at[samples.at.length - 1]!))};
  }

  /** What each curve has, read from the history once, then only what is new. */
  private samples(): Samples[] {
    return curves().map((curve) => {
      const name = nameOf(curve);
      const known = this.read.get(name);
      const begin = store.history.begin ?? Infinity;
      const fresh =
        known && known.generation === store.generation
          ? known
          : {at: [], values: [], generation: store.generation, number: 0};
      this.read.set(name, fresh);
      const read = fresh.number;
      for (const {at, value, number} of store.history.after(idOf(curve), read)) {
        addSample(fresh, at, valueOf(curve, value as Slot));
        fresh.number = Math.max(fresh.number, number);
      }
      if (store.is_log) return fresh;
      const old = fresh.at.findIndex((at) => at >= begin);
      if (old > 1000) {
        fresh.at.splice(0, old);
        fresh.values.splice(0, old);
      }
      return fresh;
    });
  }

  private options(holder: HTMLElement): uPlot.Options {
    const style = getComputedStyle(document.documentElement);
    const colour = (name: string): string => style.getPropertyValue(name).trim();
    const units = [...new Set(curves().map((curve) => unitOfField(curve.path).unit || ' '))];
    const axis = {
      stroke: colour('--muted'),
      grid: {stroke: colour('--line'), width: 1},
      ticks: {stroke: colour('--line')},
    };
    return {
      width: Math.max(50, holder.clientWidth),
      height: Math.max(50, holder.clientHeight),
      legend: {show: false},
      cursor: {drag: {x: true, y: false, setScale: false}, points: {show: true}},
      scales: {x: {time: true}},
      series: [
        {},
        ...curves().map((curve, index) => ({
          label: nameOf(curve),
          scale: unitOfField(curve.path).unit || ' ',
          stroke: colour(kColours[index]!),
          width: 1.5,
          spanGaps: true,
          points: {show: false},
          dash: index % 2 === 1 ? [6, 3] : (undefined as unknown as number[]),
        })),
      ],
      axes: [
        {...axis, values: (_plot, times) => times.map((at) => clock(at * kAxisUnit).slice(0, 8))},
        ...units.slice(0, 2).map((unit, index) => ({
          ...axis,
          scale: unit,
          side: index === 0 ? 3 : 1,
          label: unit.trim() || 'value',
          labelSize: 18,
          size: 52,
          grid: index === 0 ? axis.grid : {show: false},
        })),
      ],
      hooks: {
        draw: [(plot) => this.drawCursors(plot, colour('--accent'), colour('--warning'))],
        setCursor: [(plot) => this.onHover(plot)],
        setSelect: [(plot) => this.onSelect(plot)],
        ready: [(plot) => plot.over.addEventListener('click', (event) => this.onClick(plot, event))],
      },
    };
  }

  private drawCursors(plot: uPlot, accent: string, warning: string): void {
    const draw = (at: number | null, colour: string): void => {
      if (at === null || !Number.isFinite(at)) return;
      const x = plot.valToPos(at / kAxisUnit, 'x', true);
      const {left, top, width, height} = plot.bbox;
      if (x < left || x > left + width) return;
      plot.ctx.save();
      plot.ctx.strokeStyle = colour;
      plot.ctx.lineWidth = 1.5 * devicePixelRatio;
      plot.ctx.beginPath();
      plot.ctx.moveTo(x, top);
      plot.ctx.lineTo(x, top + height);
      plot.ctx.stroke();
      plot.ctx.restore();
    };
    draw(shownTime(), accent);
    draw(store.reference, warning);
  }

  private onSelect(plot: uPlot): void {
    const {left, width} = plot.select;
    if (width < 4) return;
    this.zoom = {min: plot.posToVal(left, 'x') * kAxisUnit, max: plot.posToVal(left + width, 'x') * kAxisUnit};
    plot.setSelect({left: 0, top: 0, width: 0, height: 0}, false);
    this.requestUpdate();
  }

  private onClick(plot: uPlot, event: MouseEvent): void {
    const at = plot.posToVal(event.offsetX, 'x') * kAxisUnit;
    if (event.shiftKey) store.setReference(at);
    else goTo(at);
  }

  private onHover(plot: uPlot): void {
    const {left} = plot.cursor;
    store.setCursor(left === undefined || left < 0 ? null : plot.posToVal(left, 'x') * kAxisUnit);
  }

  private cursorTime(): number {
    return store.cursor ?? shownTime();
  }

  private cursorWords(): string {
    return store.cursor === null ? 'the time shown' : `the pointer, ${clock(store.cursor)}`;
  }

  private renderValues(curve: Curve, index: number, samples: Samples): TemplateResult {
    const {unit} = unitOfField(curve.path);
    const value = valueAt(samples, this.cursorTime());
    const other = store.reference === null ? null : valueAt(samples, store.reference);
    const words = (number: number | null): string => (number === null ? '–' : `${plain(number)} ${unit}`);
    return html`<tr>
      <th scope="row">
        <span class="swatch curve-${index + 1}" aria-hidden="true">${index % 2 === 1 ? '┅' : '━'}</span>
        ${curve.channel} ${curve.key} ${curve.path}
      </th>
      <td class="number">${words(value)}</td>
      <td class="number">${store.reference === null ? '' : words(other)}</td>
      <td class="number">
        ${value === null || other === null ? '' : `${words(value - other)} in ${span((this.cursorTime() - store.reference!) / 1e6)}`}
      </td>
      <td class="number">
        <button class="row-button" aria-label="Remove ${curve.path}" @click=${() => addCurve(curve)}>✕</button>
      </td>
    </tr>`;
  }

  /** Around the time of the cursor. */
  private zoomBy(factor: number): void {
    const {min, max} = this.window();
    const at = Math.min(Math.max(this.cursorTime(), min), max);
    const scale = Math.max(factor, kShortest_us / (max - min));
    this.zoom = {min: at - (at - min) * scale, max: at + (max - at) * scale};
    this.requestUpdate();
  }

  private readonly wholeTime = (): void => {
    this.zoom = null;
    this.requestUpdate();
  };

  private readonly setReference = (): void => store.setReference(this.cursorTime());

  private readonly saveCsv = (): void => {
    const {min, max} = this.window();
    const channels = new Map(curves().map((curve) => [idOf(curve), curve]));
    for (const [id, curve] of channels) {
      const rows = [...store.history.between(id, min, max)].map(({at, value}) => ({
        at,
        message: (value as Slot).message,
      }));
      const states = curve.channel === 'TASK_STATE' ? store.hello?.phases : store.hello?.states[curve.channel];
      saveFile(
        `${curve.channel}${curve.key ? `-${curve.key.replace(/[^\w.-]/g, '_')}` : ''}.csv`,
        new Blob(
          [
            csvOf(
              rows.filter((row) => row.message),
              states,
            ),
          ],
          {type: 'text/csv'},
        ),
      );
    }
  };

  private readonly savePlot = (): void => {
    if (!this.plot) return;
    const ground = getComputedStyle(document.documentElement).getPropertyValue('--panel').trim();
    savePng('plot.png', this.plot.ctx.canvas, ground);
  };
}
customElements.define('mmi-plots', Plots);

function valueAt(samples: Samples, at: number): number | null {
  const index = nearestIndex(samples.at, at);
  return index < 0 ? null : (samples.values[index] ?? null);
}
