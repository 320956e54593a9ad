#pragma once

// The procedure's settings. Lengths m, times s of message time, speeds m/s of the grip point, forces N.

#include <string>

namespace markservo::task_manager {

struct LookParameters {
  int frames = 6;            // averaged before deciding: noise of one frame stays below 0.3 mm
  double unseen_time = 1.0;  // a target not located for so long counts as unseen
  double timeout = 4.0;      // for `frames` of them, and for the first word of the arm and its stop device
};

struct DriveParameters {
  double speed = 0.40;
  double clearance = 0.08;  // docked, a shelf's front is 0.17 m ahead, a table's leg 0.19 m beside; sonars err by 1 cm
  double home_tolerance = 0.05;  // rad, each joint: deadband and backlash of a folded arm
  double settle_time = 0.5;      // from arrival to the first picture that counts: the robot has swung out
  double stuck_timeout = 20.0;   // blocked or lost for so long: give up
  double silent_timeout = 2.0;   // nothing heard, or stale input told, for so long: a restarted service is back by then
  double timeout = 120.0;        // for each drive
  int corrections = 2;           // drives that follow when the target is seen where it cannot be taken
  double correction_max = 0.30;  // of one of them; further off is another mistake than a dock's
  double target_depth = 0.25;    // depth in C that a correction brings the target to: the workspace's middle
  std::string tag_field;         // of floor tags, that is driven on; empty: robot.yaml's floor_tags.in_use
};

struct MotionParameters {
  double free_speed = 0.20;    // before the row of objects
  double near_speed = 0.08;    // among the objects, and with one in the hand
  double lift_speed = 0.04;    // slow enough for the cameras to follow
  double free_step = 0.03;     // between postures on a straight line; the chord's error stays below 1 mm
  double near_step = 0.01;     // likewise below 0.1 mm
  double joint_margin = 0.02;  // rad inside the joints' limits; less than a grip's margin, so that one can lift from it
  double pass_tolerance = 0.03;  // rad, each joint: how near a posture on the way counts as passed
  double move_timeout = 8.0;     // for one posture
  double stale_timeout = 3.0;    // visual-servo reports stale input for so long: give up
  double retreat_y = 0.115;      // depth of G to which the hand leaves the row when its place is not known
  double side_yaw = 0.8;         // rad: an arm turned further is beside the shelf, and leaves along its own direction
  double side_retreat_radius = 0.08;  // of G from the column, after it left
};

struct ApproachParameters {
  double standoff_max = 0.06;  // before the grip point: 3 cm before the object's front with 1.5 cm of finger beyond G
  double standoff_step = 0.0025;        // of the search for the largest standoff in view
  double front_clearance = 0.005;       // fingertips before the objects' fronts at the first posture
  double standoff_worth_while = 0.005;  // a nearer one is not servoed to by itself
  int hand_frames = 3;                  // located in a row before servoing
  double hand_timeout = 2.0;
};

struct ServoParameters {
  double standoff_tolerance = 0.004;  // the fingers have 12 mm of room on each side
  double grip_tolerance = 0.0015;     // what the fingers even out
  double timeout = 30.0;              // for each of both goals: three times the slowest servos' 150 frames at 15 Hz
  double lost_timeout = 4.0;          // a mark unseen, with the arm held
};

struct GripParameters {
  double squeeze = 0.015;  // commanded opening below the object's width
  double force = 20.0;     // limit of each finger
  double close_time = 1.0;
  double open_time = 0.8;
  double open_enough = 0.005;  // below the largest opening: still counts as open
};

struct LiftParameters {
  double check_height = 0.012;      // a higher lift takes the mark out of view at 20 cm depth
  double check_height_min = 0.006;  // where the view allows less
  double height = 0.030;            // above its place
  double bend_max = 0.03;           // back towards the robot, where the arm does not reach straight up
  double free_height = 0.004;       // above its place, from where the object turns with the hand
  int frames = 5;                   // averaged before and after
  double marks_timeout = 2.0;       // for those frames
  double rise_share = 0.33;         // of the rise that kinematics predicts: deadbands eat half of the lowest lift
  double follow_share = 0.4;        // of the lift: the largest error of the mark's way that counts as coming along
};

// An object that stands, told from its mark.
struct ObjectShape {
  double depth = 0.12;        // behind the mark
  double below_mark = 0.162;  // its bottom under the mark's centre; the support is there
  double above_mark = 0.038;
};

struct CarryParameters {
  ObjectShape object;
  double support_half_width = 0.18;  // of the shelf's board, around the target
  double support_front = 0.004;      // the board's front edge before the mark's plane
  double retract_min = 0.10;         // searched range of the way back
  double retract_max = 0.18;
  double clearance = 0.004;         // least distance to the neighbours and the support on the way
  double place_yaw = 1.31;          // rad (75 degrees): the side table's direction from the column
  double place_radius_min = 0.175;  // of G from the column: where the side table is
  double place_radius_max = 0.24;
  double place_height = 0.0;     // the side table's top above the support
  double place_gap = 0.002;      // the object falls the last bit
  double leave_distance = 0.10;  // back off from the placed object
};

struct Parameters {
  DriveParameters drive;
  LookParameters look;
  MotionParameters motion;
  ApproachParameters approach;
  ServoParameters servo;
  GripParameters grip;
  LiftParameters lift;
  CarryParameters carry;
};

}  // namespace markservo::task_manager
