import type {Transition} from '../protocol.js';

export const kNodeWidth = 90;
export const kNodeHeight = 26;
const kGapX = 10;
const kGapY = 13;
const kColumns = 5;
const kMargin = 4;

/** Where a task begins, and where it ends; the others lie between them. */
const kEnds = new Set(['HOLD_LIFTED', 'DONE', 'REFUSED', 'FAILED', 'STOPPED']);

export interface Node {
  phase: string;
  kind: 'way' | 'end';
  x: number;
  y: number;
}

/**
 * Places for all phases: those on the way in the order in which the transitions reach them from the first phase, row by
 * row, the ends in a row of their own below.
 */
export function layOut(phases: string[], transitions: Transition[]): Node[] {
  const order = orderOf(phases, transitions);
  const way = order.filter((phase) => !kEnds.has(phase));
  const ends = order.filter((phase) => kEnds.has(phase));
  const rows_of_way = Math.ceil(way.length / kColumns);
  const place = (phase: string, index: number, row_begin: number, kind: Node['kind']): Node => ({
    phase,
    kind,
    x: kMargin + (index % kColumns) * (kNodeWidth + kGapX),
    y: kMargin + (row_begin + Math.floor(index / kColumns)) * (kNodeHeight + kGapY),
  });
  return [
    ...way.map((phase, index) => place(phase, index, 0, 'way')),
    ...ends.map((phase, index) => place(phase, index, rows_of_way, 'end')),
  ];
}

/** Longest way from the first phase along transitions that do not lead back to where the walk has been. */
function orderOf(phases: string[], transitions: Transition[]): string[] {
  const next = new Map<string, string[]>();
  for (const {from, to} of transitions) {
    if (!kEnds.has(to)) next.set(from, [...(next.get(from) ?? []), to]);
  }
  const rank = new Map<string, number>();
  const walk = (phase: string, depth: number, path: Set<string>): void => {
    if (path.has(phase) || depth > phases.length || (rank.get(phase) ?? -1) >= depth) return;
    rank.set(phase, depth);
    path.add(phase);
    for (const to of next.get(phase) ?? []) walk(to, depth + 1, path);
    path.delete(phase);
  };
  if (phases.length > 0) walk(phases[0]!, 0, new Set());
  return [...phases].sort((a, b) => (rank.get(a) ?? 99) - (rank.get(b) ?? 99) || phases.indexOf(a) - phases.indexOf(b));
}

export function sizeOf(nodes: Node[]): {width: number; height: number} {
  const right = Math.max(kNodeWidth, ...nodes.map((node) => node.x + kNodeWidth));
  const bottom = Math.max(kNodeHeight, ...nodes.map((node) => node.y + kNodeHeight));
  return {width: right + kMargin, height: bottom + kMargin};
}

/** From node to node: straight to a neighbour, else around by the gaps between the rows. */
export function edgePath(from: Node, to: Node): string {
  const middle = kNodeHeight / 2;
  if (from.y === to.y && to.x > from.x && to.x - from.x < kNodeWidth + 2 * kGapX) {
    return `M${from.x + kNodeWidth} ${from.y + middle}H${to.x}`;
  }
  const down = to.y >= from.y;
  const x1 = from.x + kNodeWidth / 2;
  const x2 = to.x + kNodeWidth / 2;
  const y1 = down ? from.y + kNodeHeight : from.y;
  const y2 = down && to.y > from.y ? to.y : down ? to.y + kNodeHeight : to.y + kNodeHeight;
  const bend = down && to.y > from.y ? (y1 + y2) / 2 : Math.max(y1, y2) + kGapY / 2;
  return `M${x1} ${y1}C${x1} ${bend} ${x2} ${bend} ${x2} ${y2}`;
}
