import type {Pose} from './drawing/geometry.js';
import type {Point} from './protocol.js';

/** What is written where a message's number is not finite. */
export const kNotANumber = 'not a number';

/** A number of a message; NaN where it is null, as mmi writes numbers that are not finite, or missing. */
export function numberOf(value: unknown): number {
  return typeof value === 'number' && Number.isFinite(value) ? value : NaN;
}

export function areFinite(values: readonly unknown[]): boolean {
  return values.every(Number.isFinite);
}

/** The pose if it can be drawn: null where one of its numbers is not finite. */
export function finitePose(pose: Pose | null | undefined): Pose | null {
  return pose && areFinite([pose.x, pose.y, pose.heading]) ? pose : null;
}

/** The point if it can be drawn: null where one of its numbers is not finite. */
export function finitePoint(point: Point | null | undefined): Point | null {
  return point && areFinite(point) ? point : null;
}

/** `write` of the number, or words where it is none. */
export function words(value: unknown, write: (value: number) => string): string {
  const number = numberOf(value);
  return Number.isNaN(number) ? kNotANumber : write(number);
}
