#include "services/mmi/scene/scene_json.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "services/mmi/scene/arm_points.hpp"
#include "services/mmi/scene/mark_words.hpp"
#include "services/mmi/scene/vector_json.hpp"

namespace markservo::mmi {
namespace {

using Json = nlohmann::ordered_json;

Json cameras_json(const robot::CameraDescription& cameras) {
  const geometry::StereoCamera& stereo = cameras.stereo;
  return {{"width_px", cameras.width}, {"height_px", cameras.height},  {"fx_px", stereo.fx},
          {"fy_px", stereo.fy},        {"cx_left_px", stereo.cx_left}, {"cx_right_px", stereo.cx_right},
          {"cy_px", stereo.cy},        {"baseline", stereo.baseline},  {"p_RC", vector_json(cameras.p_RC)}};
}

Json arm_json(const robot::RobotDescription& robot) {
  if (!robot.arm) return nullptr;
  const ArmPoints points = arm_points(robot, robot.arm->home);
  return {{"foot_R", vector_json(points[0])},
          {"column_top_R", vector_json(points[1])},
          {"reach", robot.arm->upper_arm + robot.arm->forearm}};
}

Json base_json(const robot::RobotDescription& robot) {
  if (!robot.base) return nullptr;
  Json base = {{"front", robot.base->front},
               {"rear", robot.base->rear},
               {"half_width", robot.base->half_width},
               {"sonars", nullptr}};
  if (robot.sonars) {
    base["sonars"] = {{"number", robot.sonars->number},
                      {"beam_width", robot.sonars->beam_width},
                      {"max_range", robot.sonars->max_range}};
  }
  return base;
}

Json rfid_json(const robot::RobotDescription& robot) {
  if (!robot.rfid) return nullptr;
  return {{"p_RF", vector_json(robot.rfid->p_RF)}, {"reading_radius", robot.rfid->reading_radius}};
}

Json tags_json(const robot::RobotDescription& robot, const std::string& tag_field) {
  Json tags = Json::array();
  if (!robot.floor_tags) return tags;
  for (const robot::FloorTag& tag : robot.floor_tags->field(tag_field).tags) {
    tags.push_back({{"uid", tag.uid}, {"place", vector_json(tag.p_W)}});
  }
  return tags;
}

Json marks_json(const robot::RobotDescription& robot) {
  Json marks = Json::array();
  for (const robot::MarkDescription& mark : robot.marks) {
    marks.push_back({{"name", mark.name},
                     {"role", word_of(mark.role)},
                     {"size", mark.size},
                     {"surface", word_of(mark.surface)},
                     {"outline", word_of(mark.outline)},
                     {"colour", colour_text(mark.colour)},
                     {"width", mark.grip ? Json(mark.grip->object_width) : Json(nullptr)}});
  }
  return marks;
}

}  // namespace

std::string colour_text(const robot::ColourInterval& colour) {
  constexpr double kTurn = 360.0;  // degrees
  const double width = std::fmod(colour.hue_max_deg - colour.hue_min_deg + kTurn, kTurn);
  const double hue = std::fmod(colour.hue_min_deg + 0.5 * width, kTurn);
  const double saturation = 0.5 * (colour.saturation_min + colour.saturation_max);
  const double value = 0.5 * (colour.value_min + colour.value_max);
  // A channel is at `value` within a sixth of a turn of its own hue, and falls to its lowest over the next sixth.
  const auto channel = [&](double own_hue) {
    const double away = std::abs(std::remainder(hue - own_hue, kTurn)) / 60.0;
    const double fall = std::clamp(away - 1.0, 0.0, 1.0);
    return static_cast<int>(std::lround(255.0 * value * (1.0 - saturation * fall)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(0.0), channel(120.0), channel(240.0));
}

Json scene_json(const robot::RobotDescription& robot, const std::string& tag_field) {
  return {{"cameras", cameras_json(robot.cameras)},
          {"arm", arm_json(robot)},
          {"base", base_json(robot)},
          {"rfid", rfid_json(robot)},
          {"tags", tags_json(robot, tag_field)},
          {"marks", marks_json(robot)}};
}

}  // namespace markservo::mmi
