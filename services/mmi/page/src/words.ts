import type {Moment} from './moment.js';
import type {Hello, Level, Slot} from './protocol.js';
import {bytes, microseconds} from './format.js';
import {kRecorderSilent_us} from './recorders.js';

/** What a phase means to who watches; a phase that is not listed is shown by its name alone. */
const kPhaseWords: Record<string, string> = {
  IDLE: 'waits for a task',
  DRIVE: 'drives to the target',
  LOOK: 'looks for the target',
  APPROACH: 'brings the hand into view',
  SERVO: 'goes to the grip point by sight',
  GRIP: 'grips',
  LIFT: 'lifts a little',
  VERIFY: 'looks whether the object comes along',
  LIFT_ON: 'lifts on',
  CARRY: 'carries',
  RELEASE: 'releases',
  GO_HOME: 'goes home',
  HOLD_LIFTED: 'holds the object lifted',
  DONE: 'has done it',
  REFUSED: 'refused the task',
  FAILED: 'gave up',
  STOPPED: 'has been stopped',
};

/** What a panel says where a channel has no message to show: none was heard, or the newest is none. */
export function noneWords(moment: Moment, channel: string): string {
  const bad = moment.slot(channel)?.bad;
  return bad ? `▲ The newest ${channel} is not a message: ${bad}` : `No ${channel} yet`;
}

export const kLevelSymbols: Record<Level, string> = {info: '·', good: '✓', warning: '▲', bad: '✖'};

export function phaseWord(phase: string): string {
  return kPhaseWords[phase] ?? '';
}

/** A state's name by its number; the number itself where there is no name. */
export function stateName(hello: Hello | null, what: string, number: unknown): string {
  if (typeof number === 'string' && !/^-?\d+$/.test(number)) return number;
  const names = what === 'TASK_STATE' ? hello?.phases : hello?.states?.[what];
  return names?.[Number(number)] ?? String(number ?? '–');
}

/** The phase that the robot is in; null before the first TASK_STATE. */
export function phaseOf(hello: Hello | null, moment: Moment): string | null {
  const task = moment.message('TASK_STATE');
  return task ? stateName(hello, 'TASK_STATE', task.state) : null;
}

/** A recorder that fell silent while it recorded has not ended as it should, and is told as such. */
export function recordingWords(moment: Moment): {on: boolean; text: string} {
  const age = (slot: Slot): number => moment.now - microseconds(slot.at);
  const slots = moment.slots('RECORDER_STATUS').filter((slot) => slot.message);
  const recording = slots.find((slot) => slot.message.recording && age(slot) <= kRecorderSilent_us);
  if (recording) return {on: true, text: `recording ${bytes(recording.message.bytes)}`};
  const newest = slots.sort((a, b) => age(a) - age(b))[0]?.message;
  if (newest?.recording) return {on: false, text: 'recorder silent'};
  return {on: false, text: newest?.why ? 'recording ended' : 'not recording'};
}
