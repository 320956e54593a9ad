#pragma once

// The simulator's settings: named numbers that a person sets with --set name=value and an experiment with SIM_CONTROL.

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/scene/scene.hpp"

namespace markservo::simulator {

// Units as in setting_descriptions().
struct Settings {
  double books_x = 0.0325;
  double books_y = 0.25;
  double books_slant_deg = 0.0;
  double books_friction = 0.5;

  double image_noise_sigma = 3.0;
  double image_blur_px = 0.0;
  double light_gain = 1.0;
  double light_cast_red = 1.0;
  double light_cast_green = 1.0;
  double light_cast_blue = 1.0;
  double light_vary = 1.0;

  double servo_speed_deg_s = 0.0;
  double servo_acceleration_deg_s2 = 5730.0;
  double servo_deadband_deg = 0.3;
  double servo_deadband_kind = 0.0;
  double servo_backlash_deg = 0.0;
  double servo_delay_frames = 1.0;
  double servo_delay_s = 0.0;

  double calibration_f_scale = 1.0;
  double calibration_b_scale = 1.0;
  double calibration_arm_x = 0.0;
  double calibration_arm_y = 0.0;
  double calibration_arm_z = 0.0;
  double calibration_arm_yaw_deg = 0.0;

  double arm_link_scale = 1.0;
  double arm_start_yaw_deg = 0.0;
  double arm_start_shoulder_deg = 0.0;
  double arm_start_elbow_deg = 0.0;
  double arm_start_opening = 0.0;

  double gripper_friction = 1.2;
  double gripper_speed = 0.1;

  double base_start_x = 0.0;
  double base_start_y = 0.0;
  double base_start_heading_deg = 0.0;
  double base_scale_sigma = 0.0;
  double base_drift_deg_per_sqrt_m = 0.0;
  double base_slip = 0.0;

  double rfid_missed = 0.0;
  double rfid_missing_tags = 0.0;
  double rfid_survey_error = 0.0;
  double rfid_delay_s = 0.0;
  double rfid_delay_jitter_s = 0.0;
  double rfid_read_time_known = 0.0;
  double rfid_unknown_rate = 0.0;
  double rfid_false_rate = 0.0;
  double rfid_duplicate_rate = 0.0;

  double sonar_noise = 0.01;
  double sonar_dropout = 0.02;

  double obstacle_present = 0.0;
  double obstacle_x = 0.0;
  double obstacle_y = 0.0;
  double obstacle_size = 0.3;

  double frames_rate_hz = 15.0;
  double frames_drop_rate = 0.0;

  double faults_frozen_joint = 0.0;
  double faults_frozen_camera = 0.0;
  double faults_stuck_encoder = 0.0;
  double faults_reversed_encoder = 0.0;
};

// When a changed setting shows.
enum class TakesEffect { kAtOnce, kAtReset };

struct SettingDescription {
  const char* name;
  double Settings::*value;
  double min;
  double max;
  bool whole;  // only whole numbers
  TakesEffect takes_effect;
  const char* what;  // meaning with unit
};

// All settings, in the order of the list for people.
const std::vector<SettingDescription>& setting_descriptions();

// The defaults for this robot in this scene: at the dock, its encoders, reader and tags as good as robot.yaml has them.
// Lockstep runs 30 frames a second, real time 15: what two busy cores render. Throws ConfigurationError if the robot
// has no arm.
Settings default_settings(const robot::RobotDescription& robot, const Scene& scene, bool lockstep);

// Sets one setting. Throws ConfigurationError (name, value, what is allowed) for an unknown name or an impossible
// value.
void set_value(Settings& settings, const std::string& name, double value);

// Sets one from "name=value"; throws as set_value.
void set_from_text(Settings& settings, const std::string& assignment);

// Checks what only holds for this robot: the start posture inside the arm's limits, the opening inside the gripper's,
// a reader's answer after its round. Throws ConfigurationError.
void check_against_robot(const Settings& settings, const robot::RobotDescription& robot);

// "name=value" a line, with the meaning behind it.
std::string list_settings(const Settings& settings);

}  // namespace markservo::simulator
