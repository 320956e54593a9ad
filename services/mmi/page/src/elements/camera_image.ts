import {html, nothing, type PropertyValues, type TemplateResult} from 'lit';
import {matchesOf, matchWords, nearestMatch, nextMatch, residualWords} from '../drawing/matches.js';
import {drawCross, drawNear, drawOverlay, type Side} from '../drawing/overlay.js';
import {middleOf, moved, panTo, type Lie, type Pixel} from '../drawing/pixel_cross.js';
import {span, microseconds} from '../format.js';
import {store, viewPictures} from '../session.js';
import {StoreElement} from './store_element.js';

const kZoomAtMost = 24;
const kZoomStep = 1.25;
const kKeyWords =
  "Arrows move a cross that tells a pixel's colour, with Shift by 10 px; M goes to the next match; + and - enlarge";
/** px of the screen: a match so near is pointed at. */
const kNear_px = 6;

/** One image of the pair, and over it what was found in that very frame. */
export class CameraImage extends StoreElement {
  static override properties = {side: {type: String}};
  declare side: Side;
  private zoom = 1;
  private pan: [number, number] = [0, 0];
  /** What the pointer or, while it is elsewhere, the cross of the keys is on. */
  private pointed: Pixel | null = null;
  private cross: Pixel | null = null;
  private colour = '';
  /** For screen readers: what keys led to. Not what each picture changes. */
  private spoken = '';
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
    const residuals = this.residualLine();
    return html`
      <div
        class="image-frame"
        @wheel=${this.onWheel}
        @pointerdown=${this.onDown}
        @pointermove=${this.onMove}
        @pointerup=${this.onUp}
        @pointerleave=${this.onLeave}
        @keydown=${this.onKey}
        @blur=${this.onBlur}
        tabindex="0"
        role="application"
        aria-label="${this.side} image. ${kKeyWords}"
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
            ${this.renderPointed()}
          </svg>
        </div>
        ${header ? nothing : html`<p class="empty">No picture</p>`}
      </div>
      <div class="image-foot">
        <span class="muted image-words"
          ><span>${this.footWords()}</span><span title=${residuals}>${residuals}</span></span
        >
        <span class="visually-hidden" role="status">${this.spoken}</span>
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
      this.readColour();
    } else if (!bitmap && this.drawn) {
      canvas.getContext('2d')?.clearRect(0, 0, canvas.width, canvas.height);
      this.drawn = null;
      this.readColour();
    }
    const stage = this.querySelector<HTMLElement>('.stage')!;
    stage.style.setProperty('--aspect', String(canvas.width / canvas.height));
    stage.style.setProperty('--zoom', String(this.zoom));
    stage.style.setProperty('transform', `translate(${this.pan[0]}px, ${this.pan[1]}px) scale(${this.zoom})`);
    stage.classList.toggle('is-close', this.zoom > 2);
  }

  private footWords(): string {
    const at = this.at();
    if (at) return `u ${at.u} v ${at.v} px · ${this.colour}`;
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

  private at(): Pixel | null {
    return this.pointed ?? this.cross;
  }

  private nearMatch(): ReturnType<typeof nearestMatch> {
    const at = this.at();
    const header = store.picture?.header;
    if (!at || !header) return null;
    const shown_px = this.querySelector<HTMLElement>('.stage')?.offsetWidth || header.width;
    const within_px = (kNear_px * header.width) / (shown_px * this.zoom);
    // Sharper than a pixel it cannot be pointed.
    return nearestMatch(matchesOf(header, this.side), at.u, at.v, Math.max(1, within_px));
  }

  private residualLine(): string {
    const near = this.nearMatch();
    return near ? matchWords(near) : residualWords(matchesOf(store.picture?.header, this.side));
  }

  private renderPointed(): unknown {
    const near = this.nearMatch();
    return [near ? drawNear(near, this.zoom) : nothing, this.cross ? drawCross(this.cross, this.zoom) : nothing];
  }

  private lie(): Lie {
    const stage = this.querySelector<HTMLElement>('.stage')!;
    const canvas = this.querySelector('canvas')!;
    const frame = stage.parentElement!;
    return {
      frame: [frame.clientWidth, frame.clientHeight],
      corner: [stage.offsetLeft, stage.offsetTop],
      size: [stage.offsetWidth, stage.offsetHeight],
      picture: [canvas.width, canvas.height],
      zoom: this.zoom,
      pan: this.pan,
    };
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
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const lie = this.lie();
    const from = this.cross ?? middleOf(lie);
    const to = moved(from, event.key, event.shiftKey, lie.picture) ?? this.matchFrom(from, event);
    if (to) this.moveCross(to);
    else if (event.key === '+') this.zoomBy(kZoomStep);
    else if (event.key === '-') this.zoomBy(1 / kZoomStep);
    else return;
    if (this.cross && this.zoom > 1) this.pan = panTo(this.cross, this.lie());
    event.preventDefault();
    this.requestUpdate();
  };

  /** M goes to the next match, with Shift to the one before. */
  private matchFrom(from: Pixel, event: KeyboardEvent): Pixel | null {
    if (event.key.toLowerCase() !== 'm') return null;
    const match = nextMatch(matchesOf(store.picture?.header, this.side), from.u, from.v, event.shiftKey ? -1 : 1);
    return match && {u: Math.round(match.u), v: Math.round(match.v)};
  }

  private moveCross(to: Pixel): void {
    this.pointed = null;
    this.cross = to;
    this.readColour();
    const near = this.nearMatch();
    this.spoken = this.footWords() + (near ? `, ${matchWords(near)}` : '');
  }

  private readonly onBlur = (): void => {
    this.cross = null;
    this.spoken = '';
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
    this.point(event);
    this.requestUpdate();
  };

  private readonly onUp = (): void => {
    setTimeout(() => (this.drag = null));
  };

  private readonly onLeave = (): void => {
    this.pointed = null;
    this.readColour();
    this.requestUpdate();
  };

  private point(event: PointerEvent): void {
    const canvas = this.querySelector('canvas')!;
    const box = canvas.getBoundingClientRect();
    const u = Math.floor(((event.clientX - box.left) / box.width) * canvas.width);
    const v = Math.floor(((event.clientY - box.top) / box.height) * canvas.height);
    this.pointed = u < 0 || v < 0 || u >= canvas.width || v >= canvas.height ? null : {u, v};
    this.readColour();
  }

  private readColour(): void {
    const at = this.at();
    if (!at) return;
    const [r, g, b] = this.querySelector('canvas')!.getContext('2d')!.getImageData(at.u, at.v, 1, 1).data;
    const colour = this.drawn ? `rgb ${r} ${g} ${b}` : 'no picture';
    if (colour === this.colour) return;
    this.colour = colour;
    this.requestUpdate();
  }
}
customElements.define('mmi-image', CameraImage);
