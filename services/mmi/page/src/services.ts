import {microseconds} from './format.js';
import type {Level, Slot} from './protocol.js';

export interface ServiceRow {
  key: string;
  name: string;
  state: string | null;
  reason: string;
  /** us, arrival of the newest SERVICE_STATUS. */
  at: number | null;
  process: string | null;
  pid: number | null;
  /** us, wall clock of its host: when the process began. */
  started: number | null;
  restarts: number | null;
  why: string;
  level: Level;
  /** Its newest word is no message. */
  bad: boolean;
}

/** us; a service says how it does every second. */
const kSilent_us = 3.5e6;
const kDead = new Set(['ENDED', 'FAILED', 'SILENT', 'WAITING']);
const kWaits = new Set(['waiting', 'stale']);

/** What services say of themselves beside what watches say of their processes, by name@host; the troubled ones first. */
export function joinServices(
  services: Slot[],
  processes: Slot[],
  nameOfState: (state: unknown) => string,
  now: number,
): ServiceRow[] {
  const rows = new Map<string, ServiceRow>();
  const row = (key: string, name: string): ServiceRow => {
    const known = rows.get(key);
    if (known) return known;
    const fresh: ServiceRow = {
      key,
      name,
      state: null,
      reason: '',
      at: null,
      process: null,
      pid: null,
      started: null,
      restarts: null,
      why: '',
      level: 'good',
      bad: false,
    };
    rows.set(key, fresh);
    return fresh;
  };
  for (const slot of services) {
    if (!slot.message) {
      Object.assign(row(slot.key || slot.channel, slot.key || slot.channel), badWords(slot));
      continue;
    }
    const service = row(slot.key, slot.message.name);
    Object.assign(service, {
      state: slot.message.state,
      reason: slot.message.reason,
      at: microseconds(slot.at),
      pid: slot.message.pid,
    });
  }
  for (const slot of processes) {
    if (!slot.message) {
      Object.assign(row(slot.key || slot.channel, slot.key || slot.channel), badWords(slot));
      continue;
    }
    const {name, state, pid, start_utime, restarts, why} = slot.message;
    const started = microseconds(start_utime) || null;
    Object.assign(row(slot.key, name), {process: nameOfState(state), pid: pid || null, started, restarts, why});
  }
  for (const one of rows.values()) one.level = levelOf(one, now);
  const rank: Record<Level, number> = {bad: 0, warning: 1, info: 2, good: 2};
  return [...rows.values()].sort((a, b) => rank[a.level] - rank[b.level] || (a.key < b.key ? -1 : 1));
}

function badWords(slot: Slot): Partial<ServiceRow> {
  return {bad: true, at: microseconds(slot.at), reason: `not a message: ${slot.bad ?? ''}`};
}

function levelOf(row: ServiceRow, now: number): Level {
  if (row.bad) return now - (row.at ?? now) > kSilent_us ? 'info' : 'bad';
  if (row.process === 'STOPPED') return 'info';
  if (row.process !== null && kDead.has(row.process)) return 'bad';
  if (row.at === null || now - row.at > kSilent_us) return row.process === 'STARTING' ? 'info' : 'bad';
  if (row.state !== null && kWaits.has(row.state)) return 'warning';
  // A reason beside a state of the service's own tells what it is at, and need be nothing bad.
  return row.reason === '' ? 'good' : 'info';
}
