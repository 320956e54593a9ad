#pragma once

// Logs of a camera pair, of mark-detector and of target-locator, as what a person wants to know of the cameras.

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "services/camera-check/camera_check.hpp"
#include "services/camera-check/marks/mark_sightings.hpp"

namespace markservo::camera_check {

class CameraCheckNode {
 public:
  // `robot`: the channels' prefix in the logs, empty for none.
  explicit CameraCheckNode(std::string robot) : robot_(std::move(robot)) {}

  // Takes in the pairs, detections and poses of a log; of the pairs the newest is looked at. Throws BusUnavailable for
  // what is no log, ConfigurationError for a pair whose pictures cannot be read.
  void add_log(const std::string& path);

  // What was looked at and how it is. Without a pair that is the finding.
  std::vector<Finding> findings() const;

  // {"ok", "pairs", "left", "right", "geometry", "marks", "findings"}; numbers in px, m and levels of 255.
  nlohmann::ordered_json report() const;

 private:
  std::string robot_;
  int pairs_ = 0;
  std::optional<PairReport> pair_;
  MarkSightings marks_;
};

}  // namespace markservo::camera_check
