import type {BusMessage} from './protocol.js';

export interface Leaf {
  path: string;
  value: string | number | boolean | null;
}

/** The single values of a message, named as `scripts/log export` names its columns: error_C.x, position[0]. */
export function leaves(message: BusMessage, path = ''): Leaf[] {
  if (Array.isArray(message)) return message.flatMap((part, index) => leaves(part, `${path}[${index}]`));
  if (message !== null && typeof message === 'object') {
    const names = Object.keys(message);
    if (path !== '' && names.length === 1 && names[0] === 'bytes') return [{path, value: `${message.bytes} bytes`}];
    return names.flatMap((name) => leaves(message[name], path === '' ? name : `${path}.${name}`));
  }
  return message === undefined ? [] : [{path, value: message}];
}

/** The value at a leaf's path; undefined where the message has none. */
export function leafAt(message: BusMessage, path: string): unknown {
  let value = message;
  for (const name of path.split(/[.[\]]+/)) {
    if (name === '') continue;
    if (value === null || typeof value !== 'object') return undefined;
    value = value[name];
  }
  return value;
}

/** Whether values of this leaf make a curve: numbers and truths, not the integers that name things. */
export function isPlottable(leaf: Leaf): boolean {
  if (typeof leaf.value === 'boolean') return true;
  return typeof leaf.value === 'number' && !/(^|\.)(num_\w+|\w*_size|pid|config_hash)$/.test(leaf.path);
}
