#pragma once

#include <vector>

namespace markservo::campaign {

// Bars and allowances. What is allowed beyond a bar has its reason beside it.
struct Bars {
  // Motion.
  double arm_still_rad = 0.004;     // I1, I3: the way of the farthest joint that still counts as rest
  double base_still_m = 0.002;      // I1
  double base_still_rad = 0.008;    // I1: what 2 mm are at the wheels, 0.25 m from the middle
  double base_silent_rad = 0.02;    // I3: likewise 5 mm
  double base_silent_m = 0.005;     // I3: the base's way is measured through braking, whose end is an estimate
  double arm_moves_rad_s = 0.02;    // I2
  double base_moves_m_s = 0.005;    // I2
  double latch_time = 0.3;          // s, I1: from a latch until braking begins
  double command_age = 0.3;         // s, I3: movers obey no older command, and go on with the last one as long
  double truth_period = 0.02;       // s: the mover's time is told so often
  double doubt = 0.1;               // s, I3: so much before a rule's edge two writers are plain
  double lead_doubt = 0.15;         // rad, I3: the shafts are known at 15 Hz only
  double alone = 1.0;               // s without a second one's word: then one writes alone again
  double goal_age = 0.6;            // s, I2
  double hearing = 0.15;            // s: the trial hears a message later than its reader, by a frame at most
  double arm_braking = 0.2;         // s: from 5 rad/s at 100 rad/s^2, and the frames between which truth is told
  double base_deceleration = 0.4;   // m/s^2: base-navigator brakes gently when a pose or goal is old
  double arm_deceleration = 100.0;  // rad/s^2
  double arm_settles = 0.15;        // s: the servos' lag, and half of the time between two truths
  double base_turns_rad_s = 0.02;   // I2
  double turn_deceleration = 2.0;   // rad/s^2, likewise
  double base_settles = 0.3;        // s, after braking: the wheels' own lag
  // Grip.
  double held_height_m = 0.008;  // I4: higher hangs in the hand
  double opens_m = 0.0015;       // I4: more is no slip of the fingers
  double body_still_m = 0.005;   // I12: what stands side by side with the target is rubbed by it, not moved
  double bodies_settle = 0.5;    // s, I12: a new world's bodies come to rest
  double release_seen = 0.5;     // s, I4: a release is told that much after it began, at most
  // Commands.
  std::vector<double> joint_min;    // rad, I5
  std::vector<double> joint_max;    // rad
  std::vector<double> joint_speed;  // rad/s
  double base_speed = 0.0;          // m/s
  double base_turn_rate = 0.0;      // rad/s
  double speed_share = 1.05;        // I5: of a limit, by the truth; what is driven swings over a little
  double shaft_slack = 0.03;        // rad, I5: backlash, and what a contact bends
  double lead_time = 0.3;           // s, I5: a command leads the shafts by no more than this at its own speed
  double lead_rad = 0.1;            // rad, and this
  double rounding = 1e-6;           // rad, rad/s, m/s: limits are reached, not passed
  double reset_age = 2.0;           // s, I6
  double reset_rounding = 0.02;     // s: the STOP_STATE that tells of it is stamped as it is obeyed
  double state_period = 0.25;       // s: where that one was lost, the next comes so much later
  double task_slack = 0.3;  // s, I2: from a TASK_COMMAND to the TASK_STATE that tells of it, by the frame's time
  // Health.
  double silence = 5.0;          // s, I7
  double no_network = 1.0;       // s without any message: seven services speak at 1 Hz at least
  double status_slack = 2.5;     // s: SERVICE_STATUS comes once a second, a busy machine is late
  double recovery = 15.0;        // s, I8
  double ready_age = 4.0;        // s, I8: ready within so long before the end of that
  double memory_mb = 10.0;       // I8
  double ready_share = 0.5;      // I8: of that time; at a quarter of the speed a goal is late every other moment
  double bytes_share = 0.10;     // I8, by the world's second; texts apart, which come and go with what happens
  double bytes_floor = 8.0;      // bytes a message: a number of things told more
  double varied_floor = 64.0;    // likewise, where what is seen or who speaks decides the number
  double rate_floor = 2.0;       // messages a second: what is sent at 5 Hz only while a task is under way
  double longest_text = 200.0;   // bytes: no text on the bus is longer
  double asks_rate = 0.5;        // STOPs and TASK_COMMANDs a second of the stack's own
  double words_rate = 1.2;       // SERVICE_STATUS of a service a second
  double words_of_change = 6.0;  // and so many more of each, while it comes back
  double calm = 1.0;             // s after the faults until bytes count
  double task_patience = 40.0;   // s, world, I9: a task has ended by then, however slow the machine is
  // s, world, I9: a task of which nothing changes for so long does not end; a base in whose way something stands waits
  // for 20, and none longer.
  double task_stands = 22.0;
  double task_moves = 0.01;      // rad, m: more than an arm and a base shake at rest
  double recording_gap = 5.0;    // s, I10: the next part has begun by then
  double told_to = 1.2;          // s, I10: the manifest tells what was missed within a second
  double recording_up_to = 1.5;  // s, I10: before the fault
};

}  // namespace markservo::campaign
