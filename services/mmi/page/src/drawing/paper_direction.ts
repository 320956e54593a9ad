import {nothing, svg, type SVGTemplateResult} from 'lit';
import {degrees} from '../format.js';
import {areFinite, numberOf} from '../numbers.js';
import type {FloorScale} from './floor_map.js';

/** ROBOT_POSE's `paper`, as far as it tells of the motion. */
export interface PaperMotion {
  measured_known: boolean;
  /** m in W. */
  compensated_x: number;
  compensated_y: number;
  direction_known: boolean;
  /** rad in W. */
  direction: number;
  /** m/s. */
  speed: number;
}

/** px: the arrow and its head. Its length tells nothing, the speed is in words. */
const kArrow_px = 52;
const kHead_px = 9;
const kHeadAngle = 0.45;
const kBeyondTip_px = 14;

export interface DirectionArrow {
  path: string;
  /** px, beyond the tip, and which part of the words stands there, so that they lie beside the arrow. */
  words_at: [number, number];
  anchor: 'start' | 'middle' | 'end';
  words: string;
}

/** The arrow of the motion by the paper's method, at its compensated place; null while it knows none. */
export function directionArrow(scale: FloorScale, paper: PaperMotion | null | undefined): DirectionArrow | null {
  if (!paper?.measured_known || !paper.direction_known) return null;
  if (!areFinite([paper.compensated_x, paper.compensated_y, paper.direction])) return null;
  const [x, y] = scale.at(paper.compensated_x, paper.compensated_y);
  // W's y goes up, the drawing's down.
  const along = (angle: number, length: number): [number, number] => [
    length * Math.cos(paper.direction + angle),
    -length * Math.sin(paper.direction + angle),
  ];
  const [dx, dy] = along(0, kArrow_px);
  const [tip_x, tip_y] = [x + dx, y + dy];
  const barb = (angle: number): string => {
    const [bx, by] = along(Math.PI + angle, kHead_px);
    return `M${round(tip_x)} ${round(tip_y)}l${round(bx)} ${round(by)}`;
  };
  const [wx, wy] = along(0, kArrow_px + kBeyondTip_px);
  const speed = numberOf(paper.speed);
  const speed_words = Number.isNaN(speed) ? 'speed not a number' : `${speed.toFixed(2)} m/s`;
  return {
    path: `M${round(x)} ${round(y)}L${round(tip_x)} ${round(tip_y)}${barb(kHeadAngle)}${barb(-kHeadAngle)}`,
    words_at: [x + wx, y + wy],
    anchor: Math.abs(wx) < Math.abs(wy) ? 'middle' : wx > 0 ? 'start' : 'end',
    words: `moves at ${degrees(paper.direction)}, ${speed_words}`,
  };
}

export function drawDirection(
  scale: FloorScale,
  paper: PaperMotion | null | undefined,
): SVGTemplateResult | typeof nothing {
  const arrow = directionArrow(scale, paper);
  if (!arrow) return nothing;
  const [x, y] = arrow.words_at;
  return svg`<g class="direction"><path d=${arrow.path}></path><text
    x=${round(x)} y=${round(y)} text-anchor=${arrow.anchor}>${arrow.words}</text>
    <title>direction of motion by the paper's method, counter-clockwise from W's x: ${arrow.words}</title></g>`;
}

function round(value: number): string {
  return value.toFixed(1);
}
