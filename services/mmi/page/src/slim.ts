import type {Slot} from './protocol.js';

/** The slot of a MARK_DETECTION without the marks' pixels, which are kept with the pictures only. */
export function withoutPatches(slot: Slot): Slot {
  const marks = slot.message?.marks;
  if (!Array.isArray(marks)) return slot;
  const bare = marks.map((mark) => ({
    ...mark,
    left: {...mark.left, patch: undefined},
    right: {...mark.right, patch: undefined},
  }));
  return {...slot, message: {...slot.message, marks: bare}};
}
