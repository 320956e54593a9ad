import {askForWhatIsDrawn} from './session.js';

const wanted = new Map<string, string[]>();

/** `who` needs these channels in `slots` besides what is always told. */
export function lookAt(who: string, channels: string[]): void {
  wanted.set(who, channels);
  askForWhatIsDrawn([...wanted.values()].flat());
}
