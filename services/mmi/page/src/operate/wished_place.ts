import type {Pose} from '../drawing/geometry.js';

/** m, and a degree in rad: what is pointed at is no finer than this, and what is shown is what is sent. */
const kGrid = 0.01;
const kDegree = Math.PI / 180;
/** m, and degrees, that a key moves and turns it. */
const kStep = 0.05;
const kTurn_deg = 5;
/** m; mmi takes no place that is farther. */
const kFarthest = 1e4;

const kMoves: Record<string, [number, number]> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/** rad in (-pi, pi]. */
function headingOf(degrees: number): number {
  const turned = degrees - 360 * Math.round(degrees / 360);
  return (turned === -180 ? 180 : turned) * kDegree;
}

function onGrid({x, y, heading}: Pose): Pose {
  const round = (value: number): number => Number((Math.round(value / kGrid) * kGrid).toFixed(9)) + 0;
  const near = (value: number): number => Math.min(kFarthest, Math.max(-kFarthest, round(value)));
  return {x: near(x), y: near(y), heading: headingOf(Math.round(heading / kDegree))};
}

/** The place that is pointed at, m in W, with the heading of the one before. */
export function placedAt(x: number, y: number, before: Pose | null): Pose {
  return onGrid({x, y, heading: before?.heading ?? 0});
}

/** It looks at a point, m in W. */
export function turnedTo(place: Pose, x: number, y: number): Pose {
  if (x === place.x && y === place.y) return place;
  return onGrid({...place, heading: Math.atan2(y - place.y, x - place.x)});
}

/** Where a key takes it: arrows move, with Shift they turn it, left and up to the left; null: it is no arrow key. */
export function afterPlaceKey(place: Pose, key: string, shift: boolean): Pose | null {
  const move = kMoves[key];
  if (!move) return null;
  if (shift) return onGrid({...place, heading: place.heading + kTurn_deg * kDegree * (move[1] - move[0])});
  return onGrid({...place, x: place.x + kStep * move[0], y: place.y + kStep * move[1]});
}

/** As it stands in fields to be typed into: m, m and degrees. */
export interface PlaceTexts {
  x: string;
  y: string;
  heading: string;
}

export function textsOf(place: Pose | null): PlaceTexts {
  if (!place) return {x: '', y: '', heading: ''};
  const short = (value: number): string => String(Number(value.toFixed(3)) + 0);
  return {x: short(place.x), y: short(place.y), heading: short(place.heading / kDegree)};
}

/** Null unless all three are numbers, and the place no farther than mmi takes. */
export function placeOf(texts: PlaceTexts): Pose | null {
  const [x, y, degrees] = [texts.x, texts.y, texts.heading].map((text) => (text.trim() === '' ? NaN : Number(text)));
  const good = [x, y, degrees].every((value) => Math.abs(value!) <= kFarthest);
  return good ? {x: x!, y: y!, heading: headingOf(degrees!)} : null;
}

/** For people: 0.20, 0.95 m, 90°. */
export function placeWords(place: Pose): string {
  return `${place.x.toFixed(2)}, ${place.y.toFixed(2)} m, ${(place.heading / kDegree).toFixed(0)}°`;
}
