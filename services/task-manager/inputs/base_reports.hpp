#pragma once

// What the base said of late. BASE_STATUS comes at the odometry's pace while pictures are still worked on: a step takes
// the newest word from before its frame, so that it does not matter how long the pictures took.

#include <cstddef>
#include <cstdint>
#include <deque>
#include <optional>

#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

class BaseReports {
 public:
  // A report that is older than the last begins another world: what was before is forgotten.
  void add(const BaseReport& report) {
    if (!reports_.empty() && report.utime < reports_.back().utime) reports_.clear();
    reports_.push_back(report);
    if (reports_.size() > kMost) reports_.pop_front();
  }

  // The newest with a utime before `utime` (us), if there is one.
  std::optional<BaseReport> before(std::int64_t utime) const {
    for (auto report = reports_.rbegin(); report != reports_.rend(); ++report) {
      if (report->utime < utime) return *report;
    }
    return std::nullopt;
  }

 private:
  static constexpr std::size_t kMost = 64;  // 1.3 s at 50 Hz: more than pictures take
  std::deque<BaseReport> reports_;
};

}  // namespace markservo::task_manager
