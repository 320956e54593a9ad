/** What a key asks for. */
export type Asked =
  | 'stop'
  | 'play'
  | 'next_frame'
  | 'previous_frame'
  | 'next_event'
  | 'previous_event'
  | 'newest'
  | 'theme'
  | 'view1'
  | 'view2'
  | 'view3'
  | 'view4';

const kAsked: Record<string, Asked> = {
  s: 'stop',
  S: 'stop',
  '.': 'next_frame',
  ',': 'previous_frame',
  n: 'next_event',
  p: 'previous_event',
  l: 'newest',
  t: 'theme',
  k: 'play',
  '1': 'view1',
  '2': 'view2',
  '3': 'view3',
  '4': 'view4',
};

export interface Key {
  key: string;
  /** The key's place, whatever a layout writes there. */
  code?: string;
  ctrlKey: boolean;
  altKey: boolean;
  metaKey: boolean;
}

/** What a key asks for; null: nothing of ours. Escape stops whatever has the focus, letters only where none types. */
export function keyOf(event: Key, types_text: boolean): Asked | null {
  if (event.key === 'Escape') return 'stop';
  if (types_text || event.ctrlKey || event.altKey || event.metaKey) return null;
  return kAsked[event.key] ?? (event.code === 'KeyS' ? 'stop' : null);
}

/** Whether keys that go to this element are text. */
export function typesText(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  // A list to choose from is no text: S stops there too.
  if (target.isContentEditable || target instanceof HTMLTextAreaElement) return true;
  return target instanceof HTMLInputElement && !['checkbox', 'radio', 'range', 'button'].includes(target.type);
}
