import {microseconds} from './format.js';
import type {Level, Slot} from './protocol.js';

export interface RecorderRow {
  key: string;
  host: string;
  folder: string;
  words: 'recording' | 'not recording' | 'silent' | 'garbled';
  /** Bytes; NaN where they are not told. */
  bytes: number;
  free_bytes: number;
  parts: number | null;
  why: string;
  /** us, arrival. */
  at: number;
  level: Level;
}

/** us; a recorder says how it does every second, and at its end. */
export const kRecorderSilent_us = 4e6;

/** What each recorder last said, by its RECORDER_STATUS: those that are not well first, then the newest. */
export function recorderRows(slots: Slot[], now: number): RecorderRow[] {
  const rank: Record<Level, number> = {bad: 0, warning: 1, good: 2, info: 3};
  return slots
    .map((slot) => rowOf(slot, now))
    .sort((a, b) => rank[a.level] - rank[b.level] || b.at - a.at || (a.key < b.key ? -1 : 1));
}

function rowOf(slot: Slot, now: number): RecorderRow {
  const at = microseconds(slot.at);
  const message = slot.message;
  const fields = {
    key: slot.key || slot.channel,
    at,
    host: String(message?.host ?? ''),
    folder: String(message?.folder ?? ''),
    bytes: microseconds(message?.bytes),
    free_bytes: microseconds(message?.free_bytes),
    parts: typeof message?.parts === 'number' ? message.parts : null,
    why: String(message?.why ?? ''),
  };
  if (!message) return {...fields, words: 'garbled', why: `not a message: ${slot.bad ?? ''}`, level: 'bad'};
  if (!message.recording) return {...fields, words: 'not recording', level: fields.why ? 'warning' : 'info'};
  if (now - at > kRecorderSilent_us) return {...fields, words: 'silent', level: 'bad'};
  return {...fields, words: 'recording', level: fields.why ? 'warning' : 'good'};
}
