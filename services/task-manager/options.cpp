#include "services/task-manager/options.hpp"

namespace markservo::task_manager {

void add_parameter_options(CLI::App& app, Parameters& p) {
  const auto number = [&app](const char* name, double& value, double least, double greatest, const char* text) {
    app.add_option(name, value, text)->check(CLI::Range(least, greatest))->capture_default_str();
  };
  number("--drive-speed", p.drive.speed, 0.01, 10.0, "m/s, of the base, at most");
  number("--drive-clearance", p.drive.clearance, 0.0, 5.0, "m, how near the base may come to what its sonars see");
  number("--drive-settle-time", p.drive.settle_time, 0.0, 60.0, "s, from arrival to the first picture that counts");
  number("--drive-stuck-timeout", p.drive.stuck_timeout, 0.5, 3600.0, "s, the base blocked or lost: give up");
  number("--drive-silent-timeout", p.drive.silent_timeout, 0.2, 120.0, "s, base-navigator silent or its input stale");
  number("--drive-timeout", p.drive.timeout, 1.0, 36000.0, "s, for each drive");
  app.add_option("--drive-corrections", p.drive.corrections, "Drives that may follow to bring the target within reach")
      ->check(CLI::Range(0, 10))
      ->capture_default_str();
  number("--drive-target-depth", p.drive.target_depth, 0.05, 2.0, "m before the lenses, where those bring the target");
  app.add_option("--look-frames", p.look.frames, "Frames averaged before deciding")
      ->check(CLI::Range(1, 100))
      ->capture_default_str();
  number("--unseen-time", p.look.unseen_time, 0.1, 60.0, "s, a target not located for so long counts as unseen");
  number("--free-speed", p.motion.free_speed, 0.005, 1.0, "m/s, of the hand before the books");
  number("--near-speed", p.motion.near_speed, 0.005, 1.0, "m/s, of the hand among the books or with one");
  number("--lift-speed", p.motion.lift_speed, 0.005, 1.0, "m/s, up and down with an object");
  number("--move-timeout", p.motion.move_timeout, 0.5, 120.0, "s, for one posture");
  number("--stale-timeout", p.motion.stale_timeout, 0.2, 120.0, "s, input too old to move on for so long: give up");
  number("--hand-timeout", p.approach.hand_timeout, 0.2, 120.0, "s, for the hand's mark to be seen");
  number("--grip-tolerance", p.servo.grip_tolerance, 0.0002, 0.02, "m, of the grip point");
  number("--servo-timeout", p.servo.timeout, 1.0, 600.0, "s, for each servo goal");
  number("--lost-timeout", p.servo.lost_timeout, 0.2, 120.0, "s, a mark unseen while servoing");
  number("--grip-squeeze", p.grip.squeeze, 0.0, 0.1, "m, commanded opening below the object's width");
  number("--grip-force", p.grip.force, 0.1, 1000.0, "N, limit of each finger; at most the gripper's own");
  number("--close-time", p.grip.close_time, 0.1, 30.0, "s, for the hand to close");
  number("--open-time", p.grip.open_time, 0.1, 30.0, "s, for the hand to open");
  number("--check-height", p.lift.check_height, 0.006, 0.1, "m, of the lift that verifies the grip");
  number("--rise-share", p.lift.rise_share, 0.05, 0.9, "of the predicted rise: the least that both marks must show");
  number("--lift-height", p.lift.height, 0.012, 0.2, "m, of the object above its place in the end");
  number("--object-depth", p.carry.object_depth, 0.0, 1.0, "m, of the object behind its mark");
  number("--object-below-mark", p.carry.object_below_mark, 0.0, 1.0, "m, from the mark's centre to the support");
  number("--object-above-mark", p.carry.object_above_mark, 0.0, 1.0, "m, from the mark's centre to its top");
  number("--carry-clearance", p.carry.clearance, 0.0, 0.1, "m, least distance to the neighbours on the way out");
  number("--place-yaw", p.carry.place_yaw, -3.2, 3.2, "rad, direction of the side table from the arm's column");
  number("--place-radius-min", p.carry.place_radius_min, 0.01, 2.0, "m, of the grip point at the side table");
  number("--place-radius-max", p.carry.place_radius_max, 0.01, 2.0, "m, of the grip point at the side table");
  number("--place-height", p.carry.place_height, -1.0, 1.0, "m, the side table's top above the object's support");
  number("--leave-distance", p.carry.leave_distance, 0.0, 1.0, "m, to back off from the placed object");
}

}  // namespace markservo::task_manager
