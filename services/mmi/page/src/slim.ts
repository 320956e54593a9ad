import type {BusMessage, Slot} from './protocol.js';
import {bytesOf} from './value_text.js';

const kPixels = ['bgr', 'mask'];

function withoutPixels(view: BusMessage): BusMessage {
  if (!view?.patch) return view;
  const patch = {...view.patch};
  for (const name of kPixels) {
    const bytes = bytesOf(patch[name]);
    if (bytes !== null) patch[name] = {bytes};
  }
  return {...view, patch};
}

/** The slot of a MARK_DETECTION with the number of the marks' pixels in their place: the pictures keep them. */
export function withoutPatches(slot: Slot): Slot {
  const marks = slot.message?.marks;
  if (!Array.isArray(marks)) return slot;
  const bare = marks.map((mark) => ({...mark, left: withoutPixels(mark.left), right: withoutPixels(mark.right)}));
  return {...slot, message: {...slot.message, marks: bare}};
}
