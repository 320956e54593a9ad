import {microseconds} from './format.js';
import type {RobotEvent} from './protocol.js';

/** When the phase that holds at the end of `events` began, us; null when no event tells. */
export function sinceOf(events: RobotEvent[], phase: string): number | null {
  for (let i = events.length - 1; i >= 0; i--) {
    const event = events[i]!;
    if (event.kind === 'task') return event.state === phase ? microseconds(event.at) : null;
  }
  return null;
}

/** The phases of the task under way, oldest first: since the robot last stood in one that a task begins from. */
export function phasesPassed(events: RobotEvent[]): string[] {
  const phases = events.filter((event) => event.kind === 'task').map((event) => event.state);
  const begin = phases.lastIndexOf('IDLE');
  return phases.slice(Math.max(0, begin));
}
