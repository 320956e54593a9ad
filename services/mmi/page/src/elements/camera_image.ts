import {html, nothing, type PropertyValues, type TemplateResult} from 'lit';
import {drawOverlay, type Side} from '../drawing/overlay.js';
import {span, microseconds} from '../format.js';
import {store, viewPictures} from '../session.js';
import {StoreElement} from './store_element.js';

const kZoomAtMost = 24;
const kZoomStep = 1.25;
const kPanStep_px = 40;

/** One image of the pair, and over it what was found in that very frame. */
export class CameraImage extends StoreElement {
  static override properties = {side: {type: String}};
  declare side: Side;
  private zoom = 1;
  private pan: [number, number] = [0, 0];
  private under: {u: number; v: number; colour: string} | null = null;
  private drawn: ImageBitmap | null = null;
  private drag: {x: number; y: number; moved: boolean} | null = null;

  constructor() {
    super();
    this.side = 'left';
    this.shows = ['choice', 'picture'];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.drawn = null;
    viewPictures(this, true);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    viewPictures(this, false);
  }

  protected override render(): TemplateResult {
    const header = store.picture?.header;
    const width = header?.width ?? store.hello?.scene.cameras?.width_px ?? 640;
    const height = header?.height ?? store.hello?.scene.cameras?.height_px ?? 480;
    return html`
      <div
        class="image-frame"
        @wheel=${this.onWheel}
        @pointerdown=${this.onDown}
        @pointermove=${this.onMove}
        @pointerup=${this.onUp}
        @pointerleave=${this.onLeave}
        @keydown=${this.onKey}
        tabindex="0"
        role="group"
        aria-label="${this.side} image, arrows move it when it is enlarged"
        data-side=${this.side}
        data-frame-seq=${header?.frame_seq ?? ''}
        data-frame-session=${header?.frame_session ?? ''}
      >
        <div class="stage">
          <canvas width=${width} height=${height} role="img" aria-label="${this.side} camera's picture"></canvas>
          <svg class="overlay" viewBox="0 0 ${width} ${height}" preserveAspectRatio="none">
            ${
              header
                ? drawOverlay({
                    header,
                    side: this.side,
                    marks: store.hello?.scene.marks ?? [],
                    selected: store.selected,
                    select: (name) => {
                      if (!this.drag?.moved) store.select(name);
                    },
                  })
                : nothing
            }
          </svg>
        </div>
        ${header ? nothing : html`<p class="empty">No picture</p>`}
      </div>
      <div class="image-foot">
        <span class="muted">${this.footWords()}</span>
        <span class="zoom" role="group" aria-label="Zoom of the ${this.side} image">
          <button @click=${() => this.zoomBy(1 / kZoomStep)} aria-label="Smaller" title="Smaller">−</button>
          <button @click=${this.reset} title="Whole picture" aria-label="Whole picture">
            ${Math.round(this.zoom * 100)}%
          </button>
          <button @click=${() => this.zoomBy(kZoomStep)} aria-label="Larger" title="Larger (wheel)">+</button>
        </span>
      </div>
    `;
  }

  protected override updated(_changed: PropertyValues): void {
    const canvas = this.querySelector('canvas')!;
    const bitmap = store.picture?.[this.side] ?? null;
    if (bitmap && bitmap !== this.drawn) {
      canvas.getContext('2d', {willReadFrequently: false})?.drawImage(bitmap, 0, 0);
      this.drawn = bitmap;
    } else if (!bitmap && this.drawn) {
      canvas.getContext('2d')?.clearRect(0, 0, canvas.width, canvas.height);
      this.drawn = null;
    }
    const stage = this.querySelector<HTMLElement>('.stage')!;
    stage.style.setProperty('--aspect', String(canvas.width / canvas.height));
    stage.style.setProperty('--zoom', String(this.zoom));
    stage.style.setProperty('transform', `translate(${this.pan[0]}px, ${this.pan[1]}px) scale(${this.zoom})`);
    stage.classList.toggle('is-close', this.zoom > 2);
  }

  private footWords(): string {
    if (this.under) return `u ${this.under.u} v ${this.under.v} px · ${this.under.colour}`;
    const header = store.picture?.header;
    if (!header) return this.side;
    const latency = store.moment.part('latency')?.['TARGET_POSE'];
    const age = (store.moment.now - microseconds(header.at)) / 1e6;
    const ends =
      this.side === 'left'
        ? `frame ${header.frame_seq}`
        : latency
          ? `to pose ${span(latency)}`
          : `${span(Math.max(0, age))} old`;
    return `${this.side} · ${ends}`;
  }

  private zoomBy(factor: number, at: [number, number] | null = null): void {
    const box = this.querySelector('.stage')!.parentElement!.getBoundingClientRect();
    const [x, y] = at ?? [box.width / 2, box.height / 2];
    const zoom = Math.min(kZoomAtMost, Math.max(1, this.zoom * factor));
    const ratio = zoom / this.zoom;
    const stage = this.querySelector<HTMLElement>('.stage')!;
    const origin = [stage.offsetLeft, stage.offsetTop];
    this.pan = [
      x - origin[0]! - (x - origin[0]! - this.pan[0]) * ratio,
      y - origin[1]! - (y - origin[1]! - this.pan[1]) * ratio,
    ];
    this.zoom = zoom;
    if (zoom === 1) this.pan = [0, 0];
    this.requestUpdate();
  }

  private readonly reset = (): void => {
    this.zoom = 1;
    this.pan = [0, 0];
    this.requestUpdate();
  };

  private readonly onWheel = (event: WheelEvent): void => {
    event.preventDefault();
    const box = this.querySelector('.image-frame')!.getBoundingClientRect();
    this.zoomBy(event.deltaY < 0 ? kZoomStep : 1 / kZoomStep, [event.clientX - box.left, event.clientY - box.top]);
  };

  private readonly onKey = (event: KeyboardEvent): void => {
    const by = {ArrowLeft: [1, 0], ArrowRight: [-1, 0], ArrowUp: [0, 1], ArrowDown: [0, -1]}[event.key];
    if (by && this.zoom > 1) this.pan = [this.pan[0] + kPanStep_px * by[0]!, this.pan[1] + kPanStep_px * by[1]!];
    else if (event.key === '+') this.zoomBy(kZoomStep);
    else if (event.key === '-') this.zoomBy(1 / kZoomStep);
    else return;
    event.preventDefault();
    this.requestUpdate();
  };

  private readonly onDown = (event: PointerEvent): void => {
    this.drag = {x: event.clientX - this.pan[0], y: event.clientY - this.pan[1], moved: false};
  };

  private readonly onMove = (event: PointerEvent): void => {
    if (this.drag && event.buttons & 1 && this.zoom > 1) {
      const pan: [number, number] = [event.clientX - this.drag.x, event.clientY - this.drag.y];
      if (Math.hypot(pan[0] - this.pan[0], pan[1] - this.pan[1]) > 2) this.drag.moved = true;
      this.pan = pan;
    }
    this.readPixel(event);
    this.requestUpdate();
  };

  private readonly onUp = (): void => {
    setTimeout(() => (this.drag = null));
  };

  private readonly onLeave = (): void => {
    this.under = null;
    this.requestUpdate();
  };

  private readPixel(event: PointerEvent): void {
    const canvas = this.querySelector('canvas')!;
    const box = canvas.getBoundingClientRect();
    const u = Math.floor(((event.clientX - box.left) / box.width) * canvas.width);
    const v = Math.floor(((event.clientY - box.top) / box.height) * canvas.height);
    if (u < 0 || v < 0 || u >= canvas.width || v >= canvas.height) {
      this.under = null;
      return;
    }
    const [r, g, b] = canvas.getContext('2d')!.getImageData(u, v, 1, 1).data;
    this.under = {u, v, colour: `rgb ${r} ${g} ${b}`};
  }
}
customElements.define('mmi-image', CameraImage);
