/** How keys work a list that one is chosen of. */

export interface ListState {
  open: boolean;
  /** Index of what is offered; of what is chosen while the list is closed. */
  offered: number;
}

export interface AfterKey extends ListState {
  /** What is offered is chosen now. */
  chooses: boolean;
  /** The key is used up. Escape never is: it stops the robot, wherever the focus is. */
  taken: boolean;
}

/** What a key does to a list of `count`; null: nothing. */
export function afterKey(list: ListState, key: string, count: number): AfterKey | null {
  const last = count - 1;
  if (!list.open) {
    return ['Enter', ' ', 'ArrowDown', 'ArrowUp'].includes(key) && count > 0
      ? {...list, open: true, chooses: false, taken: true}
      : null;
  }
  const go = (to: number): AfterKey => ({
    open: true,
    offered: Math.min(last, Math.max(0, to)),
    chooses: false,
    taken: true,
  });
  switch (key) {
    case 'ArrowDown':
      return go(list.offered + 1);
    case 'ArrowUp':
      return go(list.offered - 1);
    case 'Home':
      return go(0);
    case 'End':
      return go(last);
    case 'Enter':
    case ' ':
      return {...list, open: false, chooses: true, taken: true};
    case 'Tab':
      return {...list, open: false, chooses: true, taken: false};
    case 'Escape':
      return {...list, open: false, chooses: false, taken: false};
    default:
      return null;
  }
}
