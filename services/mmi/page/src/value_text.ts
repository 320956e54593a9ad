import {kMessageTypes, type MessageField} from 'lcmtypes';
import {unknownFields} from './known_values.js';
import type {BusMessage} from './protocol.js';

/** A message's values as text, as common/reflection/value_text.cpp and `scripts/log export` write them. */
export interface Cell {
  path: string;
  /** Empty: not known. */
  text: string;
}

/** A double as C++'s std::to_chars writes it: so short as reads back, with an exponent only where that is shorter. */
export function realText(value: number): string {
  if (value === 0) return Object.is(value, -0) ? '-0' : '0';
  const [mantissa, exponent] = Math.abs(value).toExponential().split('e') as [string, string];
  const place = Number(exponent);
  const scientific = `${mantissa}e${place < 0 ? '-' : '+'}${String(Math.abs(place)).padStart(2, '0')}`;
  const digits = mantissa.replace('.', '');
  const plain =
    place >= digits.length - 1
      ? BigInt(Math.abs(value)).toString()
      : place >= 0
        ? `${digits.slice(0, place + 1)}.${digits.slice(place + 1)}`
        : `0.${'0'.repeat(-place - 1)}${digits}`;
  return (value < 0 ? '-' : '') + (plain.length <= scientific.length ? plain : scientific);
}

/** Control characters, and those that turn the direction of writing. */
const kHarmful = /[\u0000-\u001f\u007f-\u009f\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069]/g;
const kWrittenOut: Record<string, string> = {'\n': '\\n', '\r': '\\r', '\t': '\\t'};

/** A text of the bus with what is harmful in it written out, as common/text's printable. */
function printable(text: string): string {
  return text.replace(kHarmful, (character) => {
    const code = character.charCodeAt(0);
    const hex = code.toString(16);
    return kWrittenOut[character] ?? (code < 0x80 ? `\\x${hex.padStart(2, '0')}` : `\\u${hex.padStart(4, '0')}`);
  });
}

/** How many bytes mmi told of: in base64, or by their number where they were too many. */
export function bytesOf(value: unknown): number | null {
  if (typeof value === 'string') return Math.floor((value.replace(/=+$/, '').length * 3) / 4);
  const number = (value as {bytes?: unknown} | null)?.bytes;
  return typeof number === 'number' ? number : null;
}

/** A plain value of a field; a number that is not finite has come as null. */
function textOf(field: MessageField, value: unknown): string {
  const is_real = field.kind === 'double' || field.kind === 'float';
  if (value === null || value === undefined) return is_real ? 'nan' : '';
  if (field.kind === 'byte' && typeof value !== 'number') return `${bytesOf(value) ?? 0} bytes`;
  if (typeof value === 'number') return field.names?.[value] ?? (is_real ? realText(value) : String(value));
  return printable(String(value));
}

function addValue(cells: Cell[], field: MessageField, value: unknown, path: string, is_known: boolean): void {
  if (Array.isArray(value)) {
    value.forEach((element, index) => addValue(cells, field, element, `${path}[${index}]`, is_known));
  } else if (field.kind in kMessageTypes && value !== null && typeof value === 'object') {
    addMessage(cells, field.kind, value, `${path}.`, is_known);
  } else {
    cells.push({path, text: is_known ? textOf(field, value) : ''});
  }
}

function addMessage(cells: Cell[], type: string, message: BusMessage, path: string, is_known: boolean): void {
  const fields = kMessageTypes[type]!;
  const unknown = unknownFields(type, message, (name) =>
    textOf(fields.find((field) => field.name === name)!, message[name]),
  );
  for (const field of fields) {
    if (message[field.name] === undefined) continue;
    addValue(cells, field, message[field.name], path + field.name, is_known && !unknown.has(field.name));
  }
}

/** All plain values of a message of one of our types, in order. */
export function cellsOf(type: string, message: BusMessage): Cell[] {
  const cells: Cell[] = [];
  addMessage(cells, type, message, '', true);
  return cells;
}

function isOf(type: string, message: BusMessage): boolean {
  const names = Object.keys(message);
  const fields = kMessageTypes[type]!;
  const holds = (field: MessageField, value: unknown): boolean => {
    if (Array.isArray(value)) return value.every((element) => holds(field, element));
    if (!(field.kind in kMessageTypes)) return true;
    return value !== null && typeof value === 'object' && isOf(field.kind, value);
  };
  return (
    fields.length === names.length &&
    fields.every((field, index) => field.name === names[index] && holds(field, message[field.name]))
  );
}

/**
 * The type of ours that a message is of, by its fields and their order: mmi tells all of them, and a channel may carry
 * another type than the table of channels has. Null: of none.
 */
export function typeOf(message: BusMessage): string | null {
  return Object.keys(kMessageTypes).find((type) => isOf(type, message)) ?? null;
}
