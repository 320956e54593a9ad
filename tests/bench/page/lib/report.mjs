// What a case has found: a line for each figure with its bar, and all as JSON.
import {mkdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';

export class Report {
  constructor(name, out) {
    this.name = name;
    this.out = out;
    this.figures = [];
    mkdirSync(out, {recursive: true});
  }

  /** `holds`: whether `figure` reaches `bar`; null: there is no bar. */
  add(what, figure, bar, holds, further = {}) {
    this.figures.push({what, figure, bar, holds, ...further});
    const mark = holds === null ? '      ' : holds ? 'ok    ' : 'FAILED';
    console.log(`${mark} ${this.name}: ${what}: ${typeof figure === 'number' ? Number(figure.toPrecision(4)) : figure}${bar ? ` (bar: ${bar})` : ''}`);
  }

  /** Whether all bars are reached. */
  end(further = {}) {
    writeFileSync(join(this.out, `${this.name}.json`), `${JSON.stringify({case: this.name, figures: this.figures, ...further}, null, 1)}\n`);
    return this.figures.every((figure) => figure.holds !== false);
  }
}

/** The value that the share `q` of `values` does not exceed; null of none. */
export function quantile(values, q) {
  if (values.length === 0) return null;
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.min(sorted.length - 1, Math.ceil(q * sorted.length) - 1)] ?? sorted[0];
}
