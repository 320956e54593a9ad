#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <markservo/RfidTagHits.hpp>
#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::rfid_localizer::test {

// The round that arrives at `utime` (us) and took 0.1 s: of the tag field `field` all within the reading radius of p_WF
// (m) answer. Without session and seq.
inline RfidTagHits tag_round(const robot::RobotDescription& robot, const std::string& field,
                             const Eigen::Vector2d& p_WF, std::int64_t utime) {
  RfidTagHits message{};
  message.utime = utime;
  message.window_start = utime - 100'000;
  message.window_end = utime;
  for (const robot::FloorTag& tag : robot.floor_tags->field(field).tags) {
    if ((tag.p_W - p_WF).norm() >= robot.rfid->reading_radius) continue;
    RfidTagHit hit{};
    hit.uid = tag.uid;
    hit.utime = utime;
    message.hits.push_back(hit);
  }
  message.num_hits = static_cast<std::int32_t>(message.hits.size());
  return message;
}

}  // namespace markservo::rfid_localizer::test
