import {leafAt} from './leaves.js';
import {unitOfField} from './format.js';
import type {Slot} from './protocol.js';
import {slotId} from './moment.js';
import {store} from './session.js';

/** One number of one channel's messages over time. */
export interface Curve {
  channel: string;
  key: string;
  path: string;
}

/** What is plotted until someone chooses: how the hand and the base come nearer. */
const chosen: Curve[] = [
  {channel: 'SERVO_STATUS', key: '', path: 'error_C.x'},
  {channel: 'SERVO_STATUS', key: '', path: 'error_C.y'},
  {channel: 'SERVO_STATUS', key: '', path: 'error_C.z'},
  {channel: 'BASE_STATUS', key: '', path: 'distance'},
];
const kCurvesAtMost = 8;

const same = (a: Curve, b: Curve): boolean => a.channel === b.channel && a.key === b.key && a.path === b.path;

export function curves(): readonly Curve[] {
  return chosen;
}

export function hasCurve(curve: Curve): boolean {
  return chosen.some((one) => same(one, curve));
}

/** Plots it; where it is plotted already, no longer. The oldest goes when there are too many. */
export function addCurve(curve: Curve): void {
  const index = chosen.findIndex((one) => same(one, curve));
  if (index >= 0) chosen.splice(index, 1);
  else chosen.push(curve);
  if (chosen.length > kCurvesAtMost) chosen.shift();
  store.tell('choice');
}

export function nameOf(curve: Curve): string {
  const {unit} = unitOfField(curve.path);
  return `${curve.channel}${curve.key ? ` ${curve.key}` : ''} ${curve.path}${unit ? `, ${unit}` : ''}`;
}

/** The number that a slot gives a curve, in the unit that it is shown in; null where it has none. */
export function valueOf(curve: Curve, slot: Slot): number | null {
  const value = leafAt(slot.message, curve.path);
  const number = typeof value === 'boolean' ? Number(value) : typeof value === 'number' ? value : NaN;
  return Number.isFinite(number) ? number * unitOfField(curve.path).factor : null;
}

export function idOf(curve: Curve): string {
  return slotId(curve.channel, curve.key);
}
