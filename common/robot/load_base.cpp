#include "common/robot/load_base.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/configuration_error.hpp"

namespace markservo::robot {
namespace {

constexpr std::size_t kMaxTags = 100'000;
const Allowed kLength = Allowed::between(1e-4, 100.0);

using geometry::radians;

BaseDescription load_base(YamlSection section) {
  BaseDescription base;
  base.wheel_radius = section.number("wheel_radius", kLength);
  base.track = section.number("track", kLength);
  base.ticks_per_turn = section.integer("ticks_per_turn", 1, 10'000'000);
  base.counter_bits = section.integer("counter_bits", 8, 32);
  YamlSection odometry = section.section("odometry");
  base.scale_sigma = odometry.number("scale_sigma", Allowed::between(0.0, 0.3));
  base.drift = radians(odometry.number("drift_deg_per_sqrt_m", Allowed::between(0.0, 60.0)));
  if (odometry.has("pivot_wander")) base.pivot_wander = odometry.number("pivot_wander", Allowed::between(0.0, 0.5));
  odometry.require_all_used();
  YamlSection outline = section.section("outline");
  base.front = outline.number("front", kLength);
  base.rear = outline.number("rear", kLength);
  base.half_width = outline.number("half_width", kLength);
  outline.require_all_used();
  base.speed_max = section.number("speed_max", Allowed::between(0.01, 10.0));
  base.turn_rate_max = radians(section.number("turn_rate_max_deg_s", Allowed::between(1.0, 1000.0)));
  base.acceleration_max = section.number("acceleration_max", Allowed::between(0.01, 50.0));
  base.turn_acceleration_max = radians(section.number("turn_acceleration_max_deg_s2", Allowed::between(1.0, 10000.0)));
  section.require_all_used();
  return base;
}

SonarRingDescription load_sonars(YamlSection section) {
  SonarRingDescription sonars;
  sonars.number = section.integer("number", 1, 64);
  sonars.ring_radius = section.number("ring_radius", kLength);
  sonars.height = section.number("height", kLength);
  sonars.beam_width = radians(section.number("beam_deg", Allowed::between(1.0, 120.0)));
  const Eigen::Vector2d range = section.numbers("range", 2, kLength);
  if (range[0] >= range[1]) section.fail("range", "falling", "[least, greatest]");
  sonars.min_range = range[0];
  sonars.max_range = range[1];
  section.require_all_used();
  return sonars;
}

RfidDescription load_rfid(YamlSection section) {
  RfidDescription rfid;
  rfid.p_RF = section.numbers("p_RF", 2, Allowed::between(-10.0, 10.0));
  rfid.reading_radius = section.number("reading_radius", Allowed::between(0.005, 10.0));
  rfid.edge_softness = section.number("edge_softness", Allowed::between(1e-4, 1.0));
  rfid.read_probability = section.number("read_probability", Allowed::between(0.05, 0.999));
  rfid.round_time = section.number("round_time", Allowed::between(0.001, 10.0));
  rfid.delay = section.number("delay", Allowed::between(0.0, 5.0));
  rfid.delay_sigma = section.number("delay_sigma", Allowed::between(0.0, 1.0));
  section.require_all_used();
  return rfid;
}

// What a person may write as a uid: 1 to 32 hexadecimal digits, stored in upper case.
std::string uid_of(YamlSection& section, const std::string& key) {
  std::string uid = section.text(key);
  const bool hexadecimal =
      std::all_of(uid.begin(), uid.end(), [](unsigned char digit) { return std::isxdigit(digit) != 0; });
  if (uid.empty() || uid.size() > 32 || !hexadecimal) {
    section.fail(key, "'" + uid + "'", "1 to 32 hexadecimal digits");
  }
  std::transform(uid.begin(), uid.end(), uid.begin(),
                 [](unsigned char digit) { return static_cast<char>(std::toupper(digit)); });
  return uid;
}

std::vector<FloorTag> load_grid(YamlSection section) {
  const int columns = section.integer("columns", 1, 1000);
  const int rows = section.integer("rows", 1, 1000);
  const double spacing = section.number("spacing", kLength);
  const std::string first = uid_of(section, "first_uid");
  section.require_all_used();
  constexpr std::size_t kCountedDigits = 8;  // the last ones; the others stay
  if (first.size() < kCountedDigits) section.fail("first_uid", "'" + first + "'", "8 or more hexadecimal digits");
  if (static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows) > kMaxTags) {
    section.fail("rows", std::to_string(rows), "at most 100000 tags in a field");
  }
  const std::string head = first.substr(0, first.size() - kCountedDigits);
  const unsigned long begin = std::strtoul(first.substr(head.size()).c_str(), nullptr, 16);
  std::vector<FloorTag> tags;
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      const std::string tail = fmt::format("{:08X}", (begin + tags.size()) & 0xFFFFFFFFUL);
      tags.push_back({head + tail, Eigen::Vector2d(column * spacing, row * spacing)});
    }
  }
  return tags;
}

std::vector<FloorTag> load_tags(YamlSection& field) {
  std::vector<FloorTag> tags;
  std::set<std::string> uids;
  for (YamlSection& section : field.list("tags")) {
    FloorTag tag;
    tag.uid = uid_of(section, "uid");
    tag.p_W = section.numbers("position", 2, Allowed::between(-1000.0, 1000.0));
    section.require_all_used();
    if (!uids.insert(tag.uid).second) section.fail("uid", "'" + tag.uid + "' twice", "a uid of its own for each tag");
    tags.push_back(tag);
  }
  if (tags.empty() || tags.size() > kMaxTags) {
    field.fail("tags", "a list of " + std::to_string(tags.size()), "1 to 100000 tags");
  }
  return tags;
}

FloorTagsDescription load_floor_tags(YamlSection section) {
  FloorTagsDescription floor;
  floor.in_use = section.text("in_use");
  floor.survey_sigma = section.number("survey_sigma", Allowed::between(0.0, 1.0));
  std::set<std::string> names;
  for (YamlSection& field_section : section.list("fields")) {
    TagField field;
    field.name = field_section.text("name");
    if (!names.insert(field.name).second) {
      field_section.fail("name", "'" + field.name + "' twice", "a name of its own for each field");
    }
    field.tags = field_section.has("grid") ? load_grid(field_section.section("grid")) : load_tags(field_section);
    field_section.require_all_used();
    floor.fields.push_back(std::move(field));
  }
  if (names.count(floor.in_use) == 0) section.fail("in_use", "'" + floor.in_use + "'", "the name of one of the fields");
  section.require_all_used();
  return floor;
}

}  // namespace

double BaseDescription::metres_per_tick() const {
  return 2.0 * M_PI * wheel_radius / ticks_per_turn;
}

geometry::PlanePose SonarRingDescription::pose(int i) const {
  const double direction = 2.0 * M_PI * i / number;
  return {ring_radius * std::cos(direction), ring_radius * std::sin(direction), direction};
}

const TagField& FloorTagsDescription::field(const std::string& name) const {
  const std::string& wanted = name.empty() ? in_use : name;
  std::string names;
  for (const TagField& candidate : fields) {
    if (candidate.name == wanted) return candidate;
    names += (names.empty() ? "" : ", ") + candidate.name;
  }
  throw ConfigurationError("tag field '" + wanted + "' is unknown; allowed: " + names);
}

void load_base_sections(YamlSection& root, RobotDescription& robot) {
  if (root.has("base")) robot.base = load_base(root.section("base"));
  if (root.has("sonars")) robot.sonars = load_sonars(root.section("sonars"));
  if (root.has("rfid")) robot.rfid = load_rfid(root.section("rfid"));
  if (root.has("floor_tags")) robot.floor_tags = load_floor_tags(root.section("floor_tags"));
}

}  // namespace markservo::robot
