import {leaves} from './leaves.js';
import type {BusMessage} from './protocol.js';
import {cellsOf, typeOf, type Cell} from './value_text.js';

function quoted(text: string): string {
  return /[",\n\r]/.test(text) ? `"${text.replace(/"/g, '""')}"` : text;
}

/** Of a message of no type of ours: as it came. */
function cellsAsTheyCame(message: BusMessage, states: string[] | undefined): Cell[] {
  return leaves(message).map(({path, value}) => {
    const name = path === 'state' && typeof value === 'number' ? states?.[value] : undefined;
    return {path, text: name ?? String(value ?? '')};
  });
}

/**
 * What `scripts/log export` writes of these messages: one row each, `at` (us) as log_utime, then the message's values
 * in the order of its type, those of later messages that earlier ones lack behind them. A value that a constant names is
 * written by that name, what another field says is not known stays empty. Not finite numbers are nan: which of them it
 * was mmi does not tell. `states` names the field `state` of a message whose type is not known.
 */
export function csvOf(rows: {at: number; message: BusMessage}[], states: string[] | undefined): string {
  const columns: string[] = [];
  const known = new Set<string>();
  const tables = rows.map(({at, message}) => {
    const type = typeOf(message);
    const cells = type === null ? cellsAsTheyCame(message, states) : cellsOf(type, message);
    for (const {path} of cells) {
      if (known.has(path)) continue;
      known.add(path);
      columns.push(path);
    }
    return {at, texts: new Map(cells.map(({path, text}) => [path, text]))};
  });
  const lines = tables.map(({at, texts}) =>
    [String(at), ...columns.map((column) => quoted(texts.get(column) ?? ''))].join(','),
  );
  return [['log_utime', ...columns.map(quoted)].join(','), ...lines, ''].join('\n');
}
