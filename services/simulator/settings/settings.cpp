#include "services/simulator/settings/settings.hpp"

#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/configuration_error.hpp"

namespace markservo::simulator {
namespace {

constexpr double kDegreesPerRadian = 57.29577951308232;

std::string text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.10g", value);
  return buffer;
}

[[noreturn]] void fail(const std::string& name, const std::string& value, const std::string& allowed) {
  throw ConfigurationError("setting '" + name + "' is " + value + "; allowed: " + allowed);
}

const SettingDescription& find(const std::string& name) {
  for (const auto& setting : setting_descriptions()) {
    if (name == setting.name) return setting;
  }
  std::string names;
  for (const auto& setting : setting_descriptions()) names += (names.empty() ? "" : ", ") + std::string(setting.name);
  throw ConfigurationError("setting '" + name + "' is unknown; allowed: " + names);
}

}  // namespace

const std::vector<SettingDescription>& setting_descriptions() {
  using S = Settings;
  constexpr auto kNow = TakesEffect::kAtOnce;
  constexpr auto kReset = TakesEffect::kAtReset;
  static const std::vector<SettingDescription> descriptions = {
      {"books.x", &S::books_x, -1.0, 1.0, false, kReset, "m, the middle book's mark in C"},
      {"books.y", &S::books_y, 0.10, 1.0, false, kReset, "m, the marks' plane in C"},
      {"books.slant_deg", &S::books_slant_deg, -60.0, 60.0, false, kReset,
       "deg, each book turned about the vertical through its mark's centre, counter-clockwise from above"},
      {"books.friction", &S::books_friction, 0.05, 2.0, false, kReset, "books on shelf, table and each other"},
      {"image.noise_sigma", &S::image_noise_sigma, 0.0, 50.0, false, kNow,
       "grey levels of 256, Gaussian, each channel"},
      {"image.blur_px", &S::image_blur_px, 0.0, 10.0, false, kNow, "px, standard deviation of the lens blur"},
      {"light.gain", &S::light_gain, 0.0, 4.0, false, kNow, "factor on every pixel"},
      {"light.cast_red", &S::light_cast_red, 0.0, 4.0, false, kNow, "factor on the red channel"},
      {"light.cast_green", &S::light_cast_green, 0.0, 4.0, false, kNow, "factor on the green channel"},
      {"light.cast_blue", &S::light_cast_blue, 0.0, 4.0, false, kNow, "factor on the blue channel"},
      {"light.vary", &S::light_vary, 0.0, 1.0, false, kReset, "how much the seed varies the lamps, 0: not at all"},
      {"servo.speed_deg_s", &S::servo_speed_deg_s, 0.0, 2000.0, false, kNow,
       "deg/s, fastest joint speed; 0: each joint's own in robot.yaml"},
      {"servo.acceleration_deg_s2", &S::servo_acceleration_deg_s2, 500.0, 1e6, false, kNow,
       "deg/s2, how fast a motor gathers speed and brakes"},
      {"servo.deadband_deg", &S::servo_deadband_deg, 0.0, 5.0, false, kNow,
       "deg, half-width around the commanded angle"},
      {"servo.deadband_kind", &S::servo_deadband_kind, 0.0, 1.0, true, kNow,
       "0: the servo stops at the deadband's edge; 1: once started it runs home"},
      {"servo.backlash_deg", &S::servo_backlash_deg, 0.0, 5.0, false, kNow, "deg, play between motor and joint"},
      {"servo.delay_frames", &S::servo_delay_frames, 0.0, 30.0, true, kNow,
       "lockstep: the answer to frame k takes effect at the exposure of frame k + this"},
      {"servo.delay_s", &S::servo_delay_s, 0.0, 1.0, false, kNow,
       "s, real time: from a command's arrival to its effect"},
      {"calibration.f_scale", &S::calibration_f_scale, 0.5, 2.0, false, kNow,
       "reported focal length over the true one"},
      {"calibration.b_scale", &S::calibration_b_scale, 0.5, 2.0, false, kNow, "reported baseline over the true one"},
      {"calibration.arm_x", &S::calibration_arm_x, -0.1, 0.1, false, kReset, "m, true arm base minus robot.yaml's"},
      {"calibration.arm_y", &S::calibration_arm_y, -0.1, 0.1, false, kReset, "m, likewise"},
      {"calibration.arm_z", &S::calibration_arm_z, -0.1, 0.1, false, kReset, "m, likewise"},
      {"calibration.arm_yaw_deg", &S::calibration_arm_yaw_deg, -20.0, 20.0, false, kReset, "deg, likewise"},
      {"arm.link_scale", &S::arm_link_scale, 0.8, 1.2, false, kReset, "true lengths of all links over robot.yaml's"},
      {"arm.start_yaw_deg", &S::arm_start_yaw_deg, -180.0, 180.0, false, kReset, "deg, at a reset"},
      {"arm.start_shoulder_deg", &S::arm_start_shoulder_deg, -180.0, 180.0, false, kReset, "deg, at a reset"},
      {"arm.start_elbow_deg", &S::arm_start_elbow_deg, -180.0, 180.0, false, kReset, "deg, at a reset"},
      {"arm.start_opening", &S::arm_start_opening, 0.0, 0.2, false, kReset, "m, gripper at a reset"},
      {"gripper.friction", &S::gripper_friction, 0.05, 3.0, false, kReset, "fingers on anything"},
      {"gripper.speed", &S::gripper_speed, 0.005, 1.0, false, kNow, "m/s, change of the opening"},
      {"base.start_x", &S::base_start_x, -100.0, 100.0, false, kReset,
       "m, where the robot starts, in W; default: docked"},
      {"base.start_y", &S::base_start_y, -100.0, 100.0, false, kReset, "m, where the robot starts, in W"},
      {"base.start_heading_deg", &S::base_start_heading_deg, -360.0, 360.0, false, kReset,
       "deg, its heading, counter-clockwise from W's x axis"},
      {"base.scale_sigma", &S::base_scale_sigma, 0.0, 0.2, false, kReset,
       "standard deviation of the factor between the true way and what the encoders tell"},
      {"base.drift_deg_per_sqrt_m", &S::base_drift_deg_per_sqrt_m, 0.0, 50.0, false, kReset,
       "deg per sqrt(m), random walk of the heading against what the encoders tell"},
      {"base.slip", &S::base_slip, 0.0, 0.5, false, kReset, "mean share of a wheel's turning that makes no way"},
      {"rfid.missed", &S::rfid_missed, 0.0, 1.0, false, kNow, "share of tag reads that fail besides"},
      {"rfid.missing_tags", &S::rfid_missing_tags, 0.0, 1.0, false, kReset,
       "share of the map's tags that are not there"},
      {"rfid.survey_error", &S::rfid_survey_error, 0.0, 1.0, false, kReset,
       "m, standard deviation of the tags' true from their mapped places, each axis"},
      {"rfid.delay_s", &S::rfid_delay_s, 0.0, 10.0, false, kNow, "s, from a round's middle to its arrival"},
      {"rfid.delay_jitter_s", &S::rfid_delay_jitter_s, 0.0, 1.0, false, kNow,
       "s, answers come up to this early or late"},
      {"rfid.read_time_known", &S::rfid_read_time_known, 0.0, 1.0, true, kNow, "1: the reader tells when it read"},
      {"rfid.unknown_rate", &S::rfid_unknown_rate, 0.0, 1.0, false, kNow, "share of rounds with a tag not in the map"},
      {"rfid.false_rate", &S::rfid_false_rate, 0.0, 1.0, false, kNow, "share of rounds with a tag that is far away"},
      {"rfid.duplicate_rate", &S::rfid_duplicate_rate, 0.0, 1.0, false, kNow, "share of reads that are told twice"},
      {"sonar.noise", &S::sonar_noise, 0.0, 1.0, false, kNow, "m, standard deviation of a range"},
      {"sonar.dropout", &S::sonar_dropout, 0.0, 1.0, false, kNow, "share of echoes that are lost"},
      {"obstacle.present", &S::obstacle_present, 0.0, 1.0, true, kNow, "1: something as tall as a person stands there"},
      {"obstacle.x", &S::obstacle_x, -100.0, 100.0, false, kNow, "m, its middle in W"},
      {"obstacle.y", &S::obstacle_y, -100.0, 100.0, false, kNow, "m, its middle in W"},
      {"obstacle.size", &S::obstacle_size, 0.01, 3.0, false, kNow, "m, edge of the square it stands on"},
      {"frames.rate_hz", &S::frames_rate_hz, 4.0, 100.0, false, kNow, "Hz"},
      {"frames.drop_rate", &S::frames_drop_rate, 0.0, 0.95, false, kNow, "share of frames that are lost"},
      {"faults.frozen_joint", &S::faults_frozen_joint, 0.0, 3.0, true, kNow,
       "JOINT_STATE tells of this joint (1 to 3) where it stood when this was set; 0: none"},
      {"faults.frozen_camera", &S::faults_frozen_camera, 0.0, 1.0, true, kNow,
       "1: the cameras show what they saw when this was set"},
      {"faults.stuck_encoder", &S::faults_stuck_encoder, 0.0, 2.0, true, kNow,
       "the encoder of this wheel (1 left, 2 right) does not count; 0: none"},
      {"faults.reversed_encoder", &S::faults_reversed_encoder, 0.0, 2.0, true, kNow,
       "the encoder of this wheel (1 left, 2 right) counts backwards; 0: none"},
  };
  return descriptions;
}

Settings default_settings(const robot::RobotDescription& robot, const Scene& scene, bool lockstep) {
  if (!robot.arm)
    throw ConfigurationError("the simulator's robot has no arm; allowed: a robot.yaml with section 'arm'");
  Settings settings;
  settings.arm_start_yaw_deg = robot.arm->home[0] * kDegreesPerRadian;
  settings.arm_start_shoulder_deg = robot.arm->home[1] * kDegreesPerRadian;
  settings.arm_start_elbow_deg = robot.arm->home[2] * kDegreesPerRadian;
  settings.arm_start_opening = robot.arm->gripper.opening_max;
  settings.base_start_x = scene.dock.x;
  settings.base_start_y = scene.dock.y;
  settings.base_start_heading_deg = scene.dock.heading_deg;
  if (robot.base) {
    settings.base_scale_sigma = robot.base->scale_sigma;
    settings.base_drift_deg_per_sqrt_m = geometry::degrees(robot.base->drift);
  }
  if (robot.rfid) settings.rfid_delay_s = robot.rfid->delay;
  if (robot.floor_tags) settings.rfid_survey_error = robot.floor_tags->survey_sigma;
  settings.frames_rate_hz = lockstep ? 30.0 : 15.0;
  return settings;
}

void set_value(Settings& settings, const std::string& name, double value) {
  const SettingDescription& setting = find(name);
  const std::string allowed = std::string(setting.whole ? "a whole number" : "a number") + " from " +
                              text(setting.min) + " to " + text(setting.max) + " (" + setting.what + ")";
  if (!std::isfinite(value) || value < setting.min || value > setting.max) fail(name, text(value), allowed);
  if (setting.whole && value != std::floor(value)) fail(name, text(value), allowed);
  settings.*setting.value = value;
}

void set_from_text(Settings& settings, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) fail(assignment, "without a value", "name=value");
  const std::string name = assignment.substr(0, equals);
  const std::string value_text = assignment.substr(equals + 1);
  find(name);
  std::size_t used = 0;
  double value = 0.0;
  try {
    value = std::stod(value_text, &used);
  } catch (const std::exception&) {
    fail(name, "'" + value_text + "'", "a number");
  }
  if (used != value_text.size()) fail(name, "'" + value_text + "'", "a number");
  set_value(settings, name, value);
}

void check_against_robot(const Settings& settings, const robot::RobotDescription& robot) {
  if (!robot.arm)
    throw ConfigurationError("the simulator's robot has no arm; allowed: a robot.yaml with section 'arm'");
  const double start[] = {settings.arm_start_yaw_deg, settings.arm_start_shoulder_deg, settings.arm_start_elbow_deg};
  const char* names[] = {"arm.start_yaw_deg", "arm.start_shoulder_deg", "arm.start_elbow_deg"};
  constexpr double kRounding_deg = 1e-9;
  for (std::size_t i = 0; i < 3; ++i) {
    const double min = robot.arm->joints[i].min * kDegreesPerRadian;
    const double max = robot.arm->joints[i].max * kDegreesPerRadian;
    if (start[i] < min - kRounding_deg || start[i] > max + kRounding_deg) {
      fail(names[i], text(start[i]), "the joint's range in robot.yaml, " + text(min) + " to " + text(max));
    }
  }
  if (settings.arm_start_opening > robot.arm->gripper.opening_max) {
    fail("arm.start_opening", text(settings.arm_start_opening),
         "up to the gripper's " + text(robot.arm->gripper.opening_max));
  }
  if (robot.rfid && settings.rfid_delay_s < 0.5 * robot.rfid->round_time) {
    fail("rfid.delay_s", text(settings.rfid_delay_s),
         "half of robot.yaml's rfid.round_time, " + text(0.5 * robot.rfid->round_time) + ", or more");
  }
}

std::string list_settings(const Settings& settings) {
  std::string list;
  for (const auto& setting : setting_descriptions()) {
    char line[256];
    std::snprintf(line, sizeof line, "%-32s # %s%s\n",
                  (std::string(setting.name) + "=" + text(settings.*setting.value)).c_str(), setting.what,
                  setting.takes_effect == TakesEffect::kAtReset ? " (from the next reset on)" : "");
    list += line;
  }
  return list;
}

}  // namespace markservo::simulator
