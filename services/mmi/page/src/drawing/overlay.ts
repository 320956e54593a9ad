import {svg, nothing, type SVGTemplateResult} from 'lit';
import type {BusMessage, MarkScene, PictureHeader} from '../protocol.js';
import {areFinite, kNotANumber} from '../numbers.js';
import {labelLevels} from './labels.js';
import {matchesOf, type Match} from './matches.js';
import type {Pixel} from './pixel_cross.js';
import {maskRuns, pathOfRuns} from './geometry.js';

export type Side = 'left' | 'right';

/** Pixel centres are at integers in messages; in the drawing pixel (0, 0) fills 0..1. */
const kHalfPixel = 0.5;
/** px of the image. */
const kLabelHeight = 17;
/** A match's line is its disparity, this many times shorter: whole ones would cover the picture. */
const kTailShortened = 10;
/** px of the image, where it is not enlarged: a ring around a match, and an arm of the cross that keys move. */
const kRing_px = 7;
const kCrossArm_px = 12;

interface Overlay {
  header: PictureHeader;
  side: Side;
  marks: MarkScene[];
  selected: string | null;
  select: (name: string) => void;
}

/** What belongs on one image of a frame, from that frame's own messages. In pixels of the image. */
export function drawOverlay(overlay: Overlay): SVGTemplateResult {
  const {header, side} = overlay;
  const seen = ((header.detection?.marks ?? []) as BusMessage[]).filter((mark) => mark[side]?.seen);
  const placed = seen.filter(({[side]: view}) => areFinite([view.u, view.v, view.x, view.y, view.width, view.height]));
  const unplaced = seen.filter((mark) => !placed.includes(mark));
  const levels = labelLevels(placed.map((mark) => ({x: mark[side].x, y: mark[side].y, letters: mark.name.length})));
  return svg`
    ${seen.map((mark) => drawMask(mark, overlay))}
    ${matchesOf(header, side).map((match) => drawMatch(match, overlay))}
    ${placed.map((mark, index) => drawMark(mark, levels[index]!, overlay))}
    ${unplaced.map((mark, index) => svg`<g class="mark"><text x="4" y=${(index + 1) * kLabelHeight}>${mark.name}: ${kNotANumber}</text></g>`)}
  `;
}

function colourOf(name: string, marks: MarkScene[]): string {
  return marks.find((mark) => mark.name === name)?.colour ?? '#ffffff';
}

function dimmed(name: string, overlay: Overlay): string {
  const selects_mark = overlay.marks.some((mark) => mark.name === overlay.selected);
  return overlay.selected === name ? 'is-selected' : selects_mark ? 'is-dimmed' : '';
}

function drawMask(mark: BusMessage, overlay: Overlay): SVGTemplateResult | typeof nothing {
  const runs = maskRuns(mark[overlay.side].patch);
  if (runs.length === 0) return nothing;
  return svg`<path class="mask ${dimmed(mark.name, overlay)}" d=${pathOfRuns(runs)} fill=${colourOf(mark.name, overlay.marks)}></path>`;
}

function drawMark(mark: BusMessage, level: number, overlay: Overlay): SVGTemplateResult {
  const view = mark[overlay.side];
  const u = view.u + kHalfPixel;
  const v = view.v + kHalfPixel;
  const label_above = view.y > kLabelHeight * (level + 1);
  const label_y = label_above ? view.y - 5 - level * kLabelHeight : view.y + view.height + 14 + level * kLabelHeight;
  return svg`<g class="mark ${dimmed(mark.name, overlay)} ${view.clipped ? 'is-clipped' : ''}" data-mark=${mark.name}
      data-u=${view.u} data-v=${view.v} data-x=${view.x} data-y=${view.y} data-width=${view.width} data-height=${view.height}
      @click=${() => overlay.select(mark.name)}>
    <rect class="halo" x=${view.x} y=${view.y} width=${view.width} height=${view.height}></rect>
    <rect class="box" x=${view.x} y=${view.y} width=${view.width} height=${view.height} stroke=${colourOf(mark.name, overlay.marks)}></rect>
    <path class="halo" d="M${u - 6} ${v}h12M${u} ${v - 6}v12"></path>
    <path class="cross" d="M${u - 6} ${v}h12M${u} ${v - 6}v12"></path>
    <text x=${Math.max(2, view.x)} y=${label_y}>${mark.name}${view.clipped ? ' (clipped)' : ''}</text>
  </g>`;
}

function drawMatch({mark, u, v, disparity, residual}: Match, overlay: Overlay): SVGTemplateResult {
  const worst = Math.min(1, Math.abs(residual));
  // What is no number is drawn as what is far off.
  const off = Number.isNaN(worst) ? 1 : worst;
  const [x, y] = [u + kHalfPixel, v + kHalfPixel];
  return svg`<g class="match ${dimmed(mark, overlay)}" data-match=${mark} data-u=${u} data-v=${v}
      data-residual=${Number.isNaN(residual) ? '' : residual}>
    <line x1=${x} y1=${y} x2=${x + disparity / kTailShortened} y2=${y}></line>
    <circle class=${off > 0.5 ? 'is-off' : ''} cx=${x} cy=${y} r=${1.2 + 1.8 * off}></circle>
  </g>`;
}

/** A match that is pointed at. */
export function drawNear(match: Match, zoom: number): SVGTemplateResult {
  return svg`<circle class="pointed near" cx=${match.u + kHalfPixel} cy=${match.v + kHalfPixel} r=${kRing_px / zoom}></circle>`;
}

/** Where keys point: the pixel itself is free, and framed. */
export function drawCross({u, v}: Pixel, zoom: number): SVGTemplateResult {
  const arm = kCrossArm_px / zoom;
  const [x, y] = [u + kHalfPixel, v + kHalfPixel];
  const path = `M${u} ${v}h1v1h-1zM${u} ${y}h${-arm}M${u + 1} ${y}h${arm}M${x} ${v}v${-arm}M${x} ${v + 1}v${arm}`;
  return svg`<g class="pointed"><path class="halo" d=${path}></path><path class="key-cross" d=${path}></path></g>`;
}
