import {svg, type SVGTemplateResult} from 'lit';
import {placeWords} from '../operate/wished_place.js';
import type {BaseScene} from '../protocol.js';
import {outlinePath, type FloorScale} from './floor_map.js';
import type {Pose} from './geometry.js';

/** px, half of the cross, and how far ahead of the robot's front its heading points. */
const kCross_px = 9;
const kArrow_px = 14;

/** Where the robot is wished to drive: its outline there, a cross, and an arrow the way that it shall look. */
export function drawWished(
  scale: FloorScale,
  pose: Pose,
  base: Pick<BaseScene, 'front' | 'rear' | 'half_width'>,
): SVGTemplateResult {
  const {front, rear, half_width} = base;
  const [x, y] = scale.at(pose.x, pose.y);
  const length = front * scale.pixels_per_metre + kArrow_px;
  const outline = outlinePath(scale, pose, [
    [front, half_width],
    [-rear, half_width],
    [-rear, -half_width],
    [front, -half_width],
  ]);
  const [, label_y] = scale.at(pose.x, pose.y - Math.hypot(front, half_width));
  return svg`<g class="pose is-wished" data-pose="wished" data-x=${pose.x} data-y=${pose.y} data-heading=${pose.heading}>
    <path d=${outline}></path>
    <path d=${`M${x - kCross_px} ${y}h${2 * kCross_px}M${x} ${y - kCross_px}v${2 * kCross_px}`}></path>
    <path d=${`M0 0H${length}m-9 -6l9 6l-9 6`} transform="translate(${x} ${y}) rotate(${(-pose.heading * 180) / Math.PI})"></path>
    <text x=${x} y=${label_y + 14}>wished</text>
    <title>wished: ${placeWords(pose)}</title></g>`;
}
