import {compose, type Pose} from './drawing/geometry.js';
import {finitePose} from './numbers.js';
import type {BusMessage} from './protocol.js';

const kDrive = 1;
const kInRobot = 1;

/** Where BASE_GOALs are in W: one in the robot's frame means the moment at which it is first heard. */
export class GoalAnchor {
  private name = '';
  private robot: Pose | null = null;

  /** The goal's pose in W; null when there is none, or the robot's own was not known. */
  goal(message: BusMessage | null, robot: Pose | null): Pose | null {
    const pose = finitePose(message?.pose);
    if (message?.kind !== kDrive || !pose) return null;
    if (message.frame !== kInRobot) return pose;
    const name = `${message.session} ${message.goal_id}`;
    if (name !== this.name) {
      this.name = name;
      this.robot = robot;
    }
    return this.robot ? compose(this.robot, pose) : null;
  }
}
