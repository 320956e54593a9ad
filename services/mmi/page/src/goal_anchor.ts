import {compose, type Pose} from './drawing/geometry.js';
import {finitePose} from './numbers.js';
import type {BusMessage} from './protocol.js';

const kDrive = 1;
const kInRobot = 1;
/** us; a goal that had been given before the source was joined is told within that: goals are repeated at 5 Hz. */
const kToldWithin_us = 1e6;
const kGoalsAtMost = 1000;

function nameOf(message: BusMessage): string {
  return `${message.session} ${message.goal_id}`;
}

/**
 * Where BASE_GOALs are in W: one in the robot's frame means the moment at which it is first heard. One that had been
 * given before we heard the source has no place that we could know.
 */
export class GoalAnchors {
  /** The robot's pose in W at each goal's first hearing; null where that is not known. */
  private readonly robots = new Map<string, Pose | null>();
  private joined_at: number | null = null;
  private newest: string | null = null;

  /** Time of the source, us; to be told before what was heard until then. */
  advance(now: number): void {
    this.joined_at ??= now;
  }

  /** The source will go on elsewhere: what it tells first may have been given long before. */
  interrupt(): void {
    this.joined_at = null;
    this.newest = null;
  }

  /** Nor does what was heard hold any more. */
  forget(): void {
    this.interrupt();
    this.robots.clear();
  }

  /** Takes in a BASE_GOAL that arrived at `at` (us), when the robot was at `robot`; null: nobody knew where. */
  observe(message: BusMessage, at: number, robot: Pose | null): void {
    const name = nameOf(message);
    if (name === this.newest) return;
    const is_first_hearing = this.newest !== null || at > (this.joined_at ?? Infinity) + kToldWithin_us;
    this.newest = name;
    if (message.kind !== kDrive || message.frame !== kInRobot || this.robots.get(name)) return;
    this.robots.set(name, is_first_hearing ? robot : null);
    if (this.robots.size > kGoalsAtMost) this.robots.delete(this.robots.keys().next().value!);
  }

  /** The goal's pose in W; null when there is none, or its place is not known. */
  goal(message: BusMessage | null): Pose | null {
    const pose = finitePose(message?.pose);
    if (message?.kind !== kDrive || !pose) return null;
    if (message.frame !== kInRobot) return pose;
    const robot = this.robots.get(nameOf(message));
    return robot ? compose(robot, pose) : null;
  }

  /** It is a goal to drive to, and nobody here knows where that is. */
  isUnplaced(message: BusMessage | null): boolean {
    return message?.kind === kDrive && finitePose(message.pose) !== null && this.goal(message) === null;
  }
}
