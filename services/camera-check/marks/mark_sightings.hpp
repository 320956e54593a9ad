#pragma once

// In how many pairs each mark was seen and located.

#include <Eigen/Core>
#include <map>
#include <string>
#include <vector>

#include "common/states/mark_cue.hpp"
#include "common/states/mark_status.hpp"
#include "services/camera-check/camera_check.hpp"

namespace markservo::camera_check {

// One mark in one pair, as mark-detector saw it.
struct SeenMark {
  std::string name;
  bool left = false;
  bool right = false;
};

// One mark in one pair, as target-locator placed it.
struct PlacedMark {
  std::string name;
  MarkStatus status = MarkStatus::kUnseen;
  MarkCue cue = MarkCue::kNone;                   // what carries the position
  int num_points = 0;                             // that carry it, of the texture or of the outline
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();  // m
};

struct MarkSighting {
  std::string name;
  int pairs = 0;  // in which it was looked for
  int left = 0;   // pairs in whose left picture it was seen
  int right = 0;
  int located = 0;
  std::map<MarkStatus, int> reasons;              // of the pairs in which it was not located
  MarkCue cue = MarkCue::kNone;                   // of the newest position
  int num_points = 0;                             // of the newest position
  Eigen::Vector3d p_C = Eigen::Vector3d::Zero();  // the newest position, m
};

class MarkSightings {
 public:
  void add(const SeenMark& mark);
  void add(const PlacedMark& mark);
  // In the order in which they were first met.
  const std::vector<MarkSighting>& all() const { return marks_; }

 private:
  MarkSighting& named(const std::string& name);

  std::vector<MarkSighting> marks_;
};

// What a located mark is measured by, for a person: "by its texture (40 points)".
std::string told_cue(const MarkSighting& mark);

// One finding a mark. Where none is located, or the two views of one do not match, something is wrong; a mark that is
// out of view is none.
std::vector<Finding> findings_of(const std::vector<MarkSighting>& marks);

}  // namespace markservo::camera_check
