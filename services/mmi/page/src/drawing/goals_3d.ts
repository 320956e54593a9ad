import {areFinite, finitePoint} from '../numbers.js';
import type {BusMessage, Covariance6, Places, PlacedMark, Point} from '../protocol.js';

/** Where something of the arm shall come to. */
export interface Goal3d {
  what: 'grip' | 'hand';
  p_R: Point;
  /** m^2, in R; null where it is not known. */
  covariance_R: Covariance6 | null;
  /** The mark that shall come there, of the hand's goal. */
  mark: PlacedMark | null;
}

/** A vector in C (x right, y forward, z up) along R's axes (x forward, y left, z up). */
function alongR(v: {x: number; y: number; z: number}): Point {
  return [v.y, -v.x, v.z];
}

function covarianceAlongR(c: {xx: number; xy: number; xz: number; yy: number; yz: number; zz: number}): Covariance6 {
  return [c.yy, -c.xy, c.yz, c.xx, -c.xz, c.zz];
}

function finite(covariance: Covariance6 | null | undefined): Covariance6 | null {
  return covariance && areFinite(covariance) ? covariance : null;
}

/**
 * The goals of a SERVO_GOAL by sight. The grip point's is its target's place and a constant, so it is as uncertain as
 * that. The hand's is where its mark lies when the grip point is there: the error that SERVO_STATUS has measured in the
 * same frame takes it there.
 */
export function goalsOf(places: Places | null, goal: BusMessage | null, status: BusMessage | null): Goal3d[] {
  const grip = finitePoint(places?.grip_goal_R);
  if (!places || !grip) return [];
  const target = places.marks.find((mark) => mark.name === goal?.target);
  const goals: Goal3d[] = [{what: 'grip', p_R: grip, covariance_R: finite(target?.covariance_R), mark: null}];
  const hand = places.marks.find((mark) => mark.role === 'manipulator' && mark.p_R !== null);
  const of_same_frame = status !== null && String(status.frame_seq) === String(places.frame_seq);
  const covariance = of_same_frame && status.covariance ? finite(covarianceAlongR(status.covariance)) : null;
  // While the error is unknown it is 0, as its covariance is.
  if (!hand?.p_R || !covariance?.some((value) => value !== 0) || !status.error_C) return goals;
  const error = alongR(status.error_C);
  const place = finitePoint(hand.p_R.map((value, k) => value - error[k]!) as Point);
  if (place) goals.push({what: 'hand', p_R: place, covariance_R: covariance, mark: hand});
  return goals;
}
