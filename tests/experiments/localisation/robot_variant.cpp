#include "tests/experiments/localisation/robot_variant.hpp"

#include <yaml-cpp/yaml.h>

#include <cmath>

#include "common/robot/configuration_error.hpp"

namespace markservo::experiments {
namespace {

void space_hall(YAML::Node fields, double spacing) {
  for (YAML::Node field : fields) {
    if (field["name"].as<std::string>() != "hall") continue;
    YAML::Node grid = field["grid"];
    const double old_spacing = grid["spacing"].as<double>();
    for (const char* count : {"columns", "rows"}) {
      const double width = (grid[count].as<int>() - 1) * old_spacing;
      grid[count] = static_cast<int>(std::lround(width / spacing)) + 1;
    }
    grid["spacing"] = spacing;
    return;
  }
  throw ConfigurationError("floor_tags.fields: has no field 'hall'; the experiment's cases need one");
}

}  // namespace

std::string robot_text(const std::string& robot_file, const RobotVariant& variant) {
  try {
    YAML::Node robot = YAML::LoadFile(robot_file);
    YAML::Node rfid = robot["rfid"];
    if (!rfid || !robot["floor_tags"] || !robot["base"]) {
      throw ConfigurationError(robot_file + ": has no base, rfid or floor_tags; the experiment needs all three");
    }
    if (variant.reading_radius) rfid["reading_radius"] = *variant.reading_radius;
    if (variant.edge_softness) rfid["edge_softness"] = *variant.edge_softness;
    if (variant.round_time) rfid["round_time"] = *variant.round_time;
    YAML::Node odometry = robot["base"]["odometry"];
    if (variant.scale_sigma) odometry["scale_sigma"] = *variant.scale_sigma;
    if (variant.drift_deg) odometry["drift_deg_per_sqrt_m"] = *variant.drift_deg;
    if (variant.spacing) space_hall(robot["floor_tags"]["fields"], *variant.spacing);
    return YAML::Dump(robot) + "\n";
  } catch (const YAML::Exception& error) {
    throw ConfigurationError(robot_file + ": " + error.what());
  }
}

}  // namespace markservo::experiments
