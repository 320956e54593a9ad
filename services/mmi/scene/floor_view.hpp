#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include "services/mmi/scene/pose_history.hpp"
#include "services/mmi/scene/reports.hpp"

namespace markservo::mmi {

// `floor` of an update: the tags of the newest round of the RFID reader, and those that it should have read where the
// robot was when it read.
class FloorView {
 public:
  struct Parameters {
    double surprise_softnesses = 5.0;  // beyond the reading radius, in edge softnesses: one read in 150 is left
    std::size_t tags_max = 10'000;     // whose reads are counted; the hall's field has 1,681
    PoseHistory::Parameters history;
  };

  // `tag_field`: a name, or empty for the field in use. Throws ConfigurationError if there is none of that name. A
  // robot without a reader or tags expects none.
  FloorView(const robot::RobotDescription& robot, const std::string& tag_field)
      : FloorView(robot, tag_field, Parameters{}) {}
  FloorView(const robot::RobotDescription& robot, const std::string& tag_field, const Parameters& parameters);

  // Takes rounds and poses, nothing else.
  void observe(const Report& report);

  // Grows whenever json() has become another; 0: nothing heard.
  std::uint64_t version() const { return version_; }
  // Null until the first round. Besides the README's fields `pose`, [x, y, heading] of the robot in W (m, rad) when the
  // round was read, or null when that is not known: then nothing is expected, and what is on the map no surprise.
  nlohmann::ordered_json json() const;

 private:
  struct Read {
    TagHit hit;
    std::int64_t count = 0;  // rounds that had it, since the start
  };
  struct Round {
    std::int64_t utime = 0;  // us
    std::optional<geometry::PlanePose> X_WR;
    std::vector<Read> read;  // each uid once
    std::vector<std::string> expected;
    std::vector<std::string> missed;
    std::vector<std::string> unexpected;
  };

  void observe_round(const RoundReport& report);
  void judge(Round& round) const;
  std::int64_t count(const std::string& uid);

  Parameters parameters_;
  std::optional<robot::RfidDescription> reader_;
  std::vector<robot::FloorTag> tags_;
  std::unordered_map<std::string, Eigen::Vector2d> places_;  // m in W, by uid
  std::unordered_map<std::string, std::int64_t> counts_;
  PoseHistory poses_;
  std::uint64_t version_ = 0;
  std::optional<Round> newest_;
};

}  // namespace markservo::mmi
