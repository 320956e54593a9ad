#include "services/simulator/settings/settings.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <stdexcept>

#include "common/robot/configuration_error.hpp"
#include "services/simulator/scene/scene.hpp"

namespace markservo::simulator {
namespace {

// Adds what a part declares. `part_of`: the part's struct of a Settings, as a member's address or a function.
template <class Part, std::size_t N, class PartOf>
void add_part(std::vector<SettingDescription>& all, const Setting<Part> (&declared)[N], PartOf part_of) {
  for (const Setting<Part>& setting : declared) {
    const auto number = setting.value;
    all.push_back(
        {setting.name, setting.min, setting.max, setting.whole, setting.takes_effect, setting.what,
         [part_of, number](const Settings& settings) { return std::invoke(part_of, settings).*number; },
         [part_of, number](Settings& settings, double value) { std::invoke(part_of, settings).*number = value; }});
  }
}

std::vector<SettingDescription> all_parts() {
  std::vector<SettingDescription> all;
  add_part(all, kBooksSettings, &Settings::books);
  add_part(all, kMarkSettings, &Settings::marks);
  add_part(all, kImageSettings, &Settings::image);
  add_part(all, kLightSettings, &Settings::light);
  add_part(all, kServoSettings, &Settings::servo);
  add_part(all, kCalibrationSettings, &Settings::calibration);
  add_part(all, kArmSettings, &Settings::arm);
  add_part(all, kGripperSettings, &Settings::gripper);
  add_part(all, kBaseSettings, &Settings::base);
  add_part(
      all, kRfidSettings, [](auto& settings) -> auto& { return settings.readers.rfid; });
  add_part(
      all, kSonarSettings, [](auto& settings) -> auto& { return settings.readers.sonar; });
  add_part(all, kObstacleSettings, &Settings::obstacle);
  add_part(all, kFramesSettings, &Settings::frames);
  add_part(all, kFaultSettings, &Settings::faults);
  return all;
}

const SettingDescription& find(const std::string& name) {
  for (const auto& setting : setting_descriptions()) {
    if (name == setting.name) return setting;
  }
  throw ConfigurationError("setting '" + name + "' is unknown; allowed: " + setting_names());
}

}  // namespace

const std::vector<SettingDescription>& setting_descriptions() {
  static const std::vector<SettingDescription> descriptions = all_parts();
  return descriptions;
}

Settings default_settings(const robot::RobotDescription& robot, const Scene& scene, bool lockstep) {
  Settings settings;
  settings.arm = default_arm_settings(arm_of(robot));
  settings.base = default_base_settings(robot, scene.dock);
  settings.readers.rfid = default_rfid_settings(robot);
  settings.frames = default_frames_settings(lockstep);
  return settings;
}

void set_value(Settings& settings, const std::string& name, double value) {
  const SettingDescription& setting = find(name);
  const std::string allowed = std::string(setting.whole ? "a whole number" : "a number") + " from " +
                              setting_text(setting.min) + " to " + setting_text(setting.max) + " (" + setting.what +
                              ")";
  if (!std::isfinite(value) || value < setting.min || value > setting.max) {
    refuse_setting(name, setting_text(value), allowed);
  }
  if (setting.whole && value != std::floor(value)) refuse_setting(name, setting_text(value), allowed);
  setting.set(settings, value);
}

Settings with_changes(Settings settings, const Assignments& changes) {
  for (const auto& [name, value] : changes) set_value(settings, name, value);
  return settings;
}

void set_from_text(Settings& settings, const std::string& assignment) {
  const std::size_t equals = assignment.find('=');
  if (equals == std::string::npos) refuse_setting(assignment, "without a value", "name=value");
  const std::string name = assignment.substr(0, equals);
  const std::string value_text = assignment.substr(equals + 1);
  find(name);
  std::size_t used = 0;
  double value = 0.0;
  try {
    value = std::stod(value_text, &used);
  } catch (const std::exception&) {
    refuse_setting(name, "'" + value_text + "'", "a number");
  }
  if (used != value_text.size()) refuse_setting(name, "'" + value_text + "'", "a number");
  set_value(settings, name, value);
}

void require_changeable(const std::string& name) {
  if (find(name).takes_effect == TakesEffect::kAtOnce) return;
  throw ConfigurationError("setting '" + name + "' cannot change in the running world; allowed: with RESET");
}

void check_against_robot(const Settings& settings, const robot::RobotDescription& robot) {
  check_arm_settings(settings.arm, arm_of(robot));
  check_rfid_settings(settings.readers.rfid, robot);
}

std::string list_settings(const Settings& settings) {
  constexpr std::size_t kNameAndValue = 32;  // characters, so that the meanings stand in a column
  std::string list;
  for (const auto& setting : setting_descriptions()) {
    std::string line = setting.name + "=" + setting_text(setting.value(settings));
    line.resize(std::max(line.size(), kNameAndValue), ' ');
    const bool waits = setting.takes_effect == TakesEffect::kAtReset;
    list += line + " # " + setting.what + (waits ? " (from the next reset on)" : "") + "\n";
  }
  return list;
}

std::string setting_names() {
  std::string names;
  for (const auto& setting : setting_descriptions()) names += (names.empty() ? "" : ", ") + setting.name;
  return names;
}

}  // namespace markservo::simulator
