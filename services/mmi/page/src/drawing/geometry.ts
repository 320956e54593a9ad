/** Geometry of what is drawn: ellipses of covariances, masks of patches, frames. */

import {numberOf} from '../numbers.js';
import type {CamerasScene, Point} from '../protocol.js';

/** Half axes of 95% of a normal distribution in two dimensions, in sigmas. */
export const kSigmas95In2D = 2.4477;
/** The same in three dimensions. */
export const kSigmas95In3D = 2.7955;

export interface Ellipse {
  /** Half axes, in the unit of the covariance's root, and the larger one's angle against the first axis, rad. */
  a: number;
  b: number;
  angle: number;
}

/**
 * The 1-sigma ellipse of a 2 x 2 covariance. What is no covariance gives an ellipse of no size, what is no number (null
 * in a message) one of NaN.
 */
export function ellipseOf(...covariance: [xx: number | null, xy: number | null, yy: number | null]): Ellipse {
  const [xx, xy, yy] = covariance.map(numberOf) as [number, number, number];
  const middle = (xx + yy) / 2;
  const spread = Math.hypot((xx - yy) / 2, xy);
  const root = (value: number): number => (value <= 0 ? 0 : Math.sqrt(value));
  return {a: root(middle + spread), b: root(middle - spread), angle: 0.5 * Math.atan2(2 * xy, xx - yy)};
}

/** Eigenvalues and eigenvectors (columns) of a symmetric 3 x 3 matrix [xx, xy, xz, yy, yz, zz], by Jacobi rotations. */
export function axesOf(covariance: readonly number[]): {values: number[]; vectors: number[][]} {
  const [xx, xy, xz, yy, yz, zz] = covariance as [number, number, number, number, number, number];
  const a = [
    [xx, xy, xz],
    [xy, yy, yz],
    [xz, yz, zz],
  ];
  const v = [
    [1, 0, 0],
    [0, 1, 0],
    [0, 0, 1],
  ];
  const rotations = [
    [0, 1],
    [0, 2],
    [1, 2],
  ] as const;
  for (let sweep = 0; sweep < 12; sweep++) {
    for (const [p, q] of rotations) {
      if (Math.abs(a[p]![q]!) < 1e-30) continue;
      const angle = 0.5 * Math.atan2(2 * a[p]![q]!, a[q]![q]! - a[p]![p]!);
      const c = Math.cos(angle);
      const s = Math.sin(angle);
      for (let k = 0; k < 3; k++) {
        const akp = a[k]![p]!;
        a[k]![p] = c * akp - s * a[k]![q]!;
        a[k]![q] = s * akp + c * a[k]![q]!;
      }
      for (let k = 0; k < 3; k++) {
        const apk = a[p]![k]!;
        a[p]![k] = c * apk - s * a[q]![k]!;
        a[q]![k] = s * apk + c * a[q]![k]!;
        const vkp = v[k]![p]!;
        v[k]![p] = c * vkp - s * v[k]![q]!;
        v[k]![q] = s * vkp + c * v[k]![q]!;
      }
    }
  }
  return {values: [a[0]![0]!, a[1]![1]!, a[2]![2]!], vectors: v};
}

export interface Pose {
  x: number;
  y: number;
  heading: number;
}

/** X_AB then X_BC: X_AC. */
export function compose(ab: Pose, bc: Pose): Pose {
  const c = Math.cos(ab.heading);
  const s = Math.sin(ab.heading);
  return {x: ab.x + c * bc.x - s * bc.y, y: ab.y + s * bc.x + c * bc.y, heading: ab.heading + bc.heading};
}

/** A point given in the pose's frame. */
export function transform(pose: Pose, x: number, y: number): [number, number] {
  const c = Math.cos(pose.heading);
  const s = Math.sin(pose.heading);
  return [pose.x + c * x - s * y, pose.y + s * x + c * y];
}

export interface Patch {
  x: number;
  y: number;
  scale: number;
  width: number;
  height: number;
  mask: unknown;
}

/** The mask's rows as runs of image pixels [u, v, length, height] (the corner of the first pixel, px); empty without one. */
export function maskRuns(patch: Patch | null | undefined): [number, number, number, number][] {
  if (!patch || !(patch.scale > 0) || typeof patch.mask !== 'string') return [];
  const bits = Uint8Array.from(atob(patch.mask), (letter) => letter.charCodeAt(0));
  const row_bytes = (patch.width + 7) >> 3;
  if (bits.length < row_bytes * patch.height) return [];
  const runs: [number, number, number, number][] = [];
  for (let j = 0; j < patch.height; j++) {
    let begin = -1;
    for (let i = 0; i <= patch.width; i++) {
      const set = i < patch.width && (bits[j * row_bytes + (i >> 3)]! >> (i & 7)) & 1;
      if (set && begin < 0) begin = i;
      if (!set && begin >= 0) {
        runs.push([patch.x + begin * patch.scale, patch.y + j * patch.scale, (i - begin) * patch.scale, patch.scale]);
        begin = -1;
      }
    }
  }
  return runs;
}

/** One path around all runs. */
export function pathOfRuns(runs: [number, number, number, number][]): string {
  return runs.map(([u, v, length, height]) => `M${u} ${v}h${length}v${height}h${-length}z`).join('');
}

/** A camera's field of view in R: its lens, and its image's corners `depth` m ahead, left top first and clockwise. */
export function frustumOf(
  cameras: CamerasScene,
  side: 'left' | 'right',
  depth: number,
): {lens: Point; corners: Point[]} {
  const [x, y, z] = cameras.p_RC;
  const lens: Point = [x, y - (side === 'left' ? 0 : cameras.baseline), z];
  const cx_px = side === 'left' ? cameras.cx_left_px : cameras.cx_right_px;
  // C's x is -R's y, and images have v downwards.
  const corner = (u: number, v: number): Point => [
    lens[0] + depth,
    lens[1] - (depth * (u - cx_px)) / cameras.fx_px,
    lens[2] - (depth * (v - cameras.cy_px)) / cameras.fy_px,
  ];
  const {width_px, height_px} = cameras;
  return {lens, corners: [corner(0, 0), corner(width_px, 0), corner(width_px, height_px), corner(0, height_px)]};
}
