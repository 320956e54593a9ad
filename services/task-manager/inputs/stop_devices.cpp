#include "services/task-manager/inputs/stop_devices.hpp"

#include <algorithm>
#include <cstdlib>

namespace markservo::task_manager {
namespace {

constexpr std::int64_t kSilence_us = 1'000'000;  // five repeats of STOP_STATE are missing

void append(std::string& list, const char* separator, const std::string& item) {
  list += (list.empty() ? "" : separator) + item;
}

void tell_latched(StopReport& report, const std::string& device, const std::string& why) {
  report.latched = true;
  append(report.reason, "; ", device + ": " + why);
}

}  // namespace

bool StopDevices::has(const std::string& device) const {
  return std::find(names_.begin(), names_.end(), device) != names_.end();
}

motion::MoverWatch& StopDevices::watch(const std::string& device) {
  return movers_.try_emplace(device, device).first->second;
}

motion::ReportHeard StopDevices::hear_stop_state(const std::string& device, const motion::Stamp& stamp, bool latched,
                                                 const std::string& reason) {
  const motion::ReportHeard heard = watch(device).hear_stop_state(stamp, latched, reason);
  if (!motion::why_dropped(heard).empty()) return heard;
  told_at_[device] = stamp.utime;
  if (latched) stopped_meanwhile_ = true;
  return heard;
}

StopReport StopDevices::report(std::int64_t now) {
  StopReport report;
  report.known = true;
  report.meanwhile = std::exchange(stopped_meanwhile_, false);
  for (const std::string& device : names_) {
    const auto told = told_at_.find(device);
    if (told == told_at_.end() || std::abs(now - told->second) > kSilence_us) {
      report.known = false;
      append(report.silent, ", ", device);
    }
    const auto found = movers_.find(device);
    if (found == movers_.end()) continue;
    const motion::MoverWatch& mover = found->second;
    if (!mover.conflict().empty()) {
      tell_latched(report, device, mover.conflict());
    } else if (mover.latched().value_or(false)) {
      tell_latched(report, device, mover.stop_reason());
    }
  }
  return report;
}

std::vector<DueStop> StopDevices::stops_due() {
  std::vector<DueStop> due;
  for (auto& [device, mover] : movers_) {
    const auto wish = mover.stop_due();
    if (!wish) continue;
    if (asked_ != std::make_pair(device, wish->id)) ++request_id_;
    asked_ = {device, wish->id};
    due.push_back({request_id_, mover.now(), *wish});
  }
  return due;
}

}  // namespace markservo::task_manager
