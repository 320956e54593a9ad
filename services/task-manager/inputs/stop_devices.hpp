#pragma once

// All that can be stopped: whose word counts for each device, how its stop stands, and what the procedure is told of
// them together.

#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "common/motion/mover_watch.hpp"
#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

// A STOP to send now.
struct DueStop {
  std::int64_t request_id = 0;  // one for the repetitions of one wish, whichever device it is for
  std::int64_t now = 0;         // us, of the device
  motion::StopWish wish;
};

class StopDevices {
 public:
  // The names as in robot.yaml's stop_devices.
  explicit StopDevices(std::vector<std::string> names = {}) : names_(std::move(names)) {}

  bool has(const std::string& device) const;
  motion::MoverWatch& watch(const std::string& device);

  motion::ReportHeard hear_stop_state(const std::string& device, const motion::Stamp& stamp, bool latched,
                                      const std::string& reason);

  // How the stops stand at `now` (us), and whether one was latched since the last report.
  StopReport report(std::int64_t now);

  // The STOPs to send now: where two claim to be one device, nothing may move until somebody has looked.
  std::vector<DueStop> stops_due();

 private:
  std::vector<std::string> names_;
  std::map<std::string, motion::MoverWatch> movers_;  // by name
  std::map<std::string, std::int64_t> told_at_;       // us, of the newest STOP_STATE that counts, likewise
  bool stopped_meanwhile_ = false;                    // one was latched since the last report
  std::int64_t request_id_ = 0;
  std::pair<std::string, std::int64_t> asked_;  // the last STOP's device, and its wish's id
};

}  // namespace markservo::task_manager
