/** One curve's samples, in the order of time. */
export interface Samples {
  /** us. */
  at: number[];
  values: (number | null)[];
  generation: number;
  /** Of the history, what has been taken in until now. */
  number: number;
}

/** Puts a sample at its time; one of the same time is replaced. */
export function addSample(samples: Samples, at: number, value: number | null): void {
  const index = nearestIndex(samples.at, at);
  if (index >= 0 && samples.at[index] === at) {
    samples.values[index] = value;
    return;
  }
  samples.at.splice(index + 1, 0, at);
  samples.values.splice(index + 1, 0, value);
}

/** One axis of time for all curves, as uPlot wants them; undefined is where a curve has no sample of its own. */
export function joinCurves(curves: Samples[], axis_unit: number): (number | null | undefined)[][] {
  const times = [...new Set(curves.flatMap((curve) => curve.at))].sort((a, b) => a - b);
  const place = new Map(times.map((at, index) => [at, index]));
  const columns = curves.map((curve) => {
    const column: (number | null | undefined)[] = new Array(times.length).fill(undefined);
    curve.at.forEach((at, index) => (column[place.get(at)!] = curve.values[index]));
    return column;
  });
  return [times.map((at) => at / axis_unit), ...columns];
}

/** The last index whose time is at or before `at`; -1 when there is none. */
export function nearestIndex(times: readonly number[], at: number): number {
  let low = 0;
  let high = times.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (times[middle]! <= at) low = middle + 1;
    else high = middle;
  }
  return low - 1;
}
