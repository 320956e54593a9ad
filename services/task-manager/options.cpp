#include "services/task-manager/options.hpp"

#include "common/bus/number_options.hpp"
#include "common/bus/options.hpp"

namespace markservo::task_manager {

void add_parameter_options(CLI::App& app, Parameters& p) {
  const bus::Options add(app);
  const bus::NumberOptions number(app);
  number("--drive-speed", p.drive.speed, "m/s, of the base, at most", 0.01, 10.0);
  number("--drive-clearance", p.drive.clearance, "m, how near the base may come to what its sonars see", 0.0, 5.0);
  number("--drive-settle-time", p.drive.settle_time, "s, from arrival to the first picture that counts", 0.0, 60.0);
  number("--drive-stuck-timeout", p.drive.stuck_timeout, "s, the base blocked or lost: give up", 0.5, 3600.0);
  number("--drive-silent-timeout", p.drive.silent_timeout, "s, base-navigator silent or its input stale", 0.2, 120.0);
  number("--drive-timeout", p.drive.timeout, "s, for each drive", 1.0, 36000.0);
  add.option("--drive-corrections", p.drive.corrections, "Drives that may follow to bring the target within reach")
      .in_range(0, 10)
      .show_default();
  number("--drive-target-depth", p.drive.target_depth, "m before the lenses, where those bring the target", 0.05, 2.0);
  add.option("--tag-field", p.drive.tag_field, "Field of floor tags in robot.yaml; default: its floor_tags.in_use");
  add.option("--look-frames", p.look.frames, "Frames averaged before deciding").in_range(1, 100).show_default();
  number("--unseen-time", p.look.unseen_time, "s, a target not located for so long counts as unseen", 0.1, 60.0);
  number("--free-speed", p.motion.free_speed, "m/s, of the hand before the row of objects", 0.005, 1.0);
  number("--near-speed", p.motion.near_speed, "m/s, of the hand among the objects or with one", 0.005, 1.0);
  number("--lift-speed", p.motion.lift_speed, "m/s, up and down with an object", 0.005, 1.0);
  number("--move-timeout", p.motion.move_timeout, "s, for one posture", 0.5, 120.0);
  number("--stale-timeout", p.motion.stale_timeout, "s, input too old to move on for so long: give up", 0.2, 120.0);
  number("--hand-timeout", p.approach.hand_timeout, "s, for the hand's mark to be seen", 0.2, 120.0);
  number("--grip-tolerance", p.servo.grip_tolerance, "m, of the grip point", 0.0002, 0.02);
  number("--servo-timeout", p.servo.timeout, "s, for each servo goal", 1.0, 600.0);
  number("--lost-timeout", p.servo.lost_timeout, "s, a mark unseen while servoing", 0.2, 120.0);
  number("--grip-squeeze", p.grip.squeeze, "m, commanded opening below the object's width", 0.0, 0.1);
  number("--grip-force", p.grip.force, "N, limit of each finger; at most the gripper's own", 0.1, 1000.0);
  number("--close-time", p.grip.close_time, "s, for the hand to close", 0.1, 30.0);
  number("--open-time", p.grip.open_time, "s, for the hand to open", 0.1, 30.0);
  number("--check-height", p.lift.check_height, "m, of the lift that verifies the grip", 0.006, 0.1);
  number("--rise-share", p.lift.rise_share, "of the predicted rise: the least that both marks must show", 0.05, 0.9);
  number("--lift-height", p.lift.height, "m, of the object above its place in the end", 0.012, 0.2);
  number("--object-depth", p.carry.object.depth, "m, of the object behind its mark", 0.0, 1.0);
  number("--object-below-mark", p.carry.object.below_mark, "m, from the mark's centre to the support", 0.0, 1.0);
  number("--object-above-mark", p.carry.object.above_mark, "m, from the mark's centre to its top", 0.0, 1.0);
  number("--carry-clearance", p.carry.clearance, "m, least distance to the neighbours on the way out", 0.0, 0.1);
  number("--place-yaw", p.carry.place_yaw, "rad, direction of the side table from the arm's column", -3.2, 3.2);
  number("--place-radius-min", p.carry.place_radius_min, "m, of the grip point at the side table", 0.01, 2.0);
  number("--place-radius-max", p.carry.place_radius_max, "m, of the grip point at the side table", 0.01, 2.0);
  number("--place-height", p.carry.place_height, "m, the side table's top above the object's support", -1.0, 1.0);
  number("--leave-distance", p.carry.leave_distance, "m, to back off from the placed object", 0.0, 1.0);
}

}  // namespace markservo::task_manager
