import {leaves} from './leaves.js';
import type {BusMessage} from './protocol.js';

/** Fields whose numbers are shown by name in tables, with the names. */
export type StateNames = Record<string, string[]>;

function cell(value: unknown): string {
  if (value === null || value === undefined) return '';
  const text = String(value);
  return /[",\n\r]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}

/**
 * One row a message: log_utime, then the message's values in its own order, those of later messages that earlier ones
 * lack behind them; the columns of `scripts/log export`.
 */
export function csvOf(rows: {at: number; message: BusMessage}[], states: string[] | undefined): string {
  const columns: string[] = [];
  const known = new Set<string>();
  const tables = rows.map(({at, message}) => {
    const values = new Map<string, unknown>();
    for (const leaf of leaves(message)) {
      const named =
        leaf.path === 'state' && typeof leaf.value === 'number' ? (states?.[leaf.value] ?? leaf.value) : leaf.value;
      values.set(leaf.path, named);
      if (known.has(leaf.path)) continue;
      known.add(leaf.path);
      columns.push(leaf.path);
    }
    return {at, values};
  });
  const lines = tables.map(({at, values}) =>
    [String(at), ...columns.map((column) => cell(values.get(column)))].join(','),
  );
  return [['log_utime', ...columns.map(cell)].join(','), ...lines, ''].join('\n');
}
