import type {TagScene, FloorRound, SonarEchoMessage} from '../protocol.js';
import {transform, type Pose} from './geometry.js';

export type TagState = 'read' | 'missed' | 'expected' | 'unexpected' | 'idle';

/** What the newest round says of each tag that it says anything of. */
export function tagStates(floor: FloorRound | null): Map<string, TagState> {
  const states = new Map<string, TagState>();
  if (!floor) return states;
  for (const uid of floor.expected) states.set(uid, 'expected');
  for (const uid of floor.missed) states.set(uid, 'missed');
  for (const tag of floor.read) states.set(tag.uid, 'read');
  for (const uid of floor.unexpected) states.set(uid, 'unexpected');
  return states;
}

/** How the floor is mapped to the drawing: W's x to the right, y up. */
export class FloorScale {
  constructor(
    readonly pixels_per_metre: number,
    readonly centre: [number, number],
    readonly size: [number, number],
  ) {}

  /** m in W to px. */
  at(x: number, y: number): [number, number] {
    return [
      this.size[0] / 2 + (x - this.centre[0]) * this.pixels_per_metre,
      this.size[1] / 2 - (y - this.centre[1]) * this.pixels_per_metre,
    ];
  }

  /** px to m in W. */
  placeAt(u: number, v: number): [number, number] {
    return [
      this.centre[0] + (u - this.size[0] / 2) / this.pixels_per_metre,
      this.centre[1] - (v - this.size[1] / 2) / this.pixels_per_metre,
    ];
  }
}

/** The scale at which all points and a margin (m) around them are in view. */
export function scaleToFit(points: [number, number][], margin: number, size: [number, number]): FloorScale {
  if (points.length === 0) return new FloorScale(Math.min(...size) / 4, [0, 0], size);
  const [xs, ys] = [points.map((point) => point[0]), points.map((point) => point[1])];
  const [left, right, bottom, top] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const scale = Math.min(size[0] / (right - left + 2 * margin), size[1] / (top - bottom + 2 * margin));
  return new FloorScale(scale, [(left + right) / 2, (bottom + top) / 2], size);
}

/** A path through points of the robot's frame, closed. */
export function outlinePath(scale: FloorScale, robot: Pose, points: [number, number][]): string {
  const corners = points.map(([x, y]) =>
    scale
      .at(...transform(robot, x, y))
      .map((value) => value.toFixed(1))
      .join(' '),
  );
  return `M${corners.join('L')}Z`;
}

const kFanSteps = 6;

/** A sonar's fan: from the sonar to the arc at which it heard something. */
export function fanPath(scale: FloorScale, robot: Pose, echo: SonarEchoMessage, beam_width: number): string {
  const points: [number, number][] = [[echo.pose.x, echo.pose.y]];
  for (let i = 0; i <= kFanSteps; i++) {
    const angle = echo.pose.heading + (i / kFanSteps - 0.5) * beam_width;
    points.push([echo.pose.x + echo.range * Math.cos(angle), echo.pose.y + echo.range * Math.sin(angle)]);
  }
  return outlinePath(scale, robot, points);
}

/** Tags by uid. */
export function tagPlaces(tags: TagScene[]): Map<string, [number, number]> {
  return new Map(tags.map((tag) => [tag.uid, tag.place]));
}
