import {clock} from './format.js';
import type {Store} from './store.js';

/** What the page says of the time that it shows; null when that is the newest, and nobody asked for another. */
export function pastWords(store: Pick<Store, 'paused_at' | 'shown_past' | 'past_is_lost' | 'notice'>): string | null {
  if (store.paused_at === null) return store.notice === '' ? null : `${store.notice} · key L: understood`;
  if (!store.past_is_lost) return 'PAST · key L for live';
  return (
    `PAST · ${clock(store.paused_at).slice(0, 8)} is no longer kept: ` +
    `the oldest that is, ${clock(store.shown_past).slice(0, 8)} UTC, is shown · key L for live`
  );
}
