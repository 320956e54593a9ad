#pragma once

// The simulator's settings: named numbers that a person sets with --set name=value and an experiment with SIM_CONTROL.
// Each part declares its own beside what they act on; here they are put together.

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/arm/arm_settings.hpp"
#include "services/simulator/arm/gripper_settings.hpp"
#include "services/simulator/arm/servo_settings.hpp"
#include "services/simulator/base/base_settings.hpp"
#include "services/simulator/cameras/calibration_settings.hpp"
#include "services/simulator/cameras/frames_settings.hpp"
#include "services/simulator/cameras/image_settings.hpp"
#include "services/simulator/cameras/light_settings.hpp"
#include "services/simulator/faults/fault_settings.hpp"
#include "services/simulator/marks/mark_settings.hpp"
#include "services/simulator/readers/reader_settings.hpp"
#include "services/simulator/scene/books_settings.hpp"
#include "services/simulator/scene/obstacle_settings.hpp"
#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct Scene;

struct Settings {
  BooksSettings books;
  MarkSettings marks;
  ObstacleSettings obstacle;
  ImageSettings image;
  LightSettings light;
  FramesSettings frames;
  CalibrationSettings calibration;
  ServoSettings servo;
  ArmSettings arm;
  GripperSettings gripper;
  BaseSettings base;
  ReaderSettings readers;
  FaultSettings faults;
};

// One number of any part.
struct SettingDescription {
  std::string name;
  double min;
  double max;
  bool whole;  // only whole numbers
  TakesEffect takes_effect;
  std::string what;  // meaning with unit
  std::function<double(const Settings&)> value;
  std::function<void(Settings&, double)> set;  // without a check
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

// Names and values as SIM_CONTROL carries them.
using Assignments = std::vector<std::pair<std::string, double>>;

// `settings` with `changes` on top; throws as set_value.
Settings with_changes(Settings settings, const Assignments& changes);

// Sets one from "name=value"; throws as set_value.
void set_from_text(Settings& settings, const std::string& assignment);

// Throws ConfigurationError for a setting that shows only after a reset.
void require_changeable(const std::string& name);

// Checks what only holds for this robot: the start posture inside the arm's limits, the opening inside the gripper's,
// a reader's answer after its round. Throws ConfigurationError.
void check_against_robot(const Settings& settings, const robot::RobotDescription& robot);

// "name=value" a line, with the meaning behind it.
std::string list_settings(const Settings& settings);

// "name, name, ..." of all settings.
std::string setting_names();

}  // namespace markservo::simulator
