/** The points that were matched between the two images of a frame, and how far each is off. */

import type {BusMessage, PictureHeader} from '../protocol.js';
import {areFinite, numberOf} from '../numbers.js';

export interface Match {
  mark: string;
  /** px of the image, pixel centres at integers. */
  u: number;
  v: number;
  /** px, from this point's u to that in the other image; 0 where that is not told. */
  disparity: number;
  /** px, as it was published; NaN where it is no number. */
  residual: number;
}

/** Those with a place in this image of the frame; none where the frame has no matches. */
export function matchesOf(header: PictureHeader | undefined, side: 'left' | 'right'): Match[] {
  return ((header?.matches?.marks ?? []) as BusMessage[]).flatMap((mark) => {
    const us: number[] = mark[`u_${side}`] ?? [];
    const vs: number[] = mark[`v_${side}`] ?? [];
    const other_us: number[] = mark[side === 'left' ? 'u_right' : 'u_left'] ?? [];
    return us.flatMap((u, index) => {
      const v = vs[index]!;
      if (!areFinite([u, v])) return [];
      const other = numberOf(other_us[index]);
      return {
        mark: mark.name as string,
        u,
        v,
        disparity: Number.isNaN(other) ? 0 : other - u,
        residual: numberOf(mark.residual?.[index]),
      };
    });
  });
}

/** Mean and largest size of the residuals, in words; empty without matches. */
export function residualWords(matches: readonly Match[]): string {
  if (matches.length === 0) return '';
  const sizes = matches.map((match) => Math.abs(match.residual)).filter(Number.isFinite);
  const unknown = matches.length - sizes.length;
  if (sizes.length === 0) return `${matches.length} residuals: not a number`;
  const none = unknown > 0 ? `, ${unknown} not a number` : '';
  const mean = sizes.reduce((sum, size) => sum + size, 0) / sizes.length;
  const largest = sizes.reduce((most, size) => Math.max(most, size), 0);
  return `${matches.length} residuals: mean ${mean.toFixed(2)}, max ${pixels(largest)}${none}`;
}

/** One match, in words. */
export function matchWords(match: Match): string {
  return `match of ${match.mark}, residual ${Number.isNaN(match.residual) ? 'not a number' : pixels(match.residual)}`;
}

/** The match that is nearest to a pixel, of those within so many px; null: none is. */
export function nearestMatch(matches: readonly Match[], u: number, v: number, within_px: number): Match | null {
  let nearest: Match | null = null;
  let distance = within_px;
  for (const match of matches) {
    const away = Math.hypot(match.u - u, match.v - v);
    if (away > distance) continue;
    nearest = match;
    distance = away;
  }
  return nearest;
}

/** The first match after a pixel in reading order (by -1: the last before it); after the last the first again. */
export function nextMatch(matches: readonly Match[], u: number, v: number, by: 1 | -1): Match | null {
  const order = (a: {u: number; v: number}, b: {u: number; v: number}): number => a.v - b.v || a.u - b.u;
  const rows = matches.map((match) => ({match, u: Math.round(match.u), v: Math.round(match.v)})).sort(order);
  const place = {u, v};
  const found =
    by === 1 ? rows.find((row) => order(row, place) > 0) : rows.reverse().find((row) => order(row, place) < 0);
  return (found ?? rows[0])?.match ?? null;
}

function pixels(value: number): string {
  return `${value.toFixed(2)} px`;
}
