#include "services/mmi/control/robot_answers.hpp"

#include "services/mmi/stop/device_silence.hpp"

namespace markservo::mmi {
namespace {

// As StopRequest.source names a stop from a page, and STOP_STATE.reason begins.
constexpr const char* kFromAPage = "page: ";

}  // namespace

RobotAnswers::RobotAnswers(const std::vector<std::string>& stop_devices, bool drives) : drives_(drives) {
  for (const std::string& device : stop_devices) devices_[device];
}

void RobotAnswers::observe(const task::StopReport& report, bool asked, double now) {
  const auto found = devices_.find(report.device);
  if (found == devices_.end()) return;
  found->second = {report, asked, now};
}

void RobotAnswers::observe(const task::TaskReport& report, double now) {
  task_ = report;
  task_heard_ = now;
}

void RobotAnswers::observe_conflict(const std::string& words, double now) {
  two_ = words;
  two_heard_ = now;
}

void RobotAnswers::tell(task::Dialogue& dialogue, double now) const {
  for (const auto& [name, device] : devices_) {
    if (device.report) dialogue.observe(*device.report);
  }
  if (task_ && !task_is_silent(now)) dialogue.observe(*task_, now);
}

std::string RobotAnswers::why_not(task::Action action, double now) const {
  if (action == task::Action::kAbort) return why_no_abort(now);
  if (const std::string silent = silent_devices(now); !silent.empty()) {
    return "no STOP_STATE of " + silent + ": is its driver running?";
  }
  if (action == task::Action::kReset) return why_no_reset();
  if (action == task::Action::kDrive && !drives_) return "the robot has no base";
  return why_no_motion(now);
}

std::string RobotAnswers::silent_devices(double now) const {
  std::string names;
  for (const auto& [name, device] : devices_) {
    if (device.report && now - device.heard <= kDeviceSilence) continue;
    names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

bool RobotAnswers::task_is_silent(double now) const {
  return !task_ || now - task_heard_ > kDeviceSilence;
}

std::string RobotAnswers::why_no_motion(double now) const {
  for (const auto& [name, device] : devices_) {
    if (device.report->latched) return "stopped (" + name + ": " + device.report->reason + "): reset releases it";
  }
  if (!two_.empty() && now - two_heard_ <= kDeviceSilence) return two_ + ": end one of them, then reset";
  if (task_is_silent(now)) return "no TASK_STATE: do cameras, detector, locator, servo and task-manager run?";
  if (under_way(task_->phase)) return std::string("a task is under way (") + name_of(task_->phase) + "): abort ends it";
  return {};
}

std::string RobotAnswers::why_no_reset() const {
  bool latched = false;
  for (const auto& [name, device] : devices_) {
    if (!device.report->latched) continue;
    latched = true;
    const bool another = device.asked && device.report->reason.rfind(kFromAPage, 0) != 0;
    if (another)
      return "another stopped it (" + name + ": " + device.report->reason + "): scripts/task reset releases it";
  }
  return latched ? "" : "nothing is stopped";
}

std::string RobotAnswers::why_no_abort(double now) const {
  if (task_is_silent(now)) return {};  // it is heard all the same, if it can hear
  return under_way(task_->phase) ? "" : "no task is under way";
}

}  // namespace markservo::mmi
