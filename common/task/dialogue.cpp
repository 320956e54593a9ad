#include "common/task/dialogue.hpp"

#include <fmt/core.h>

#include <utility>

namespace markservo::task {
namespace {

std::string with_reason(const std::string& text, const std::string& reason) {
  return reason.empty() ? text : text + ": " + reason;
}

std::string describe(const TaskReport& task) {
  std::string text = name_of(task.phase);
  if (!task.target.empty()) text += " " + task.target;
  if (task.attempt > 1) text += " (attempt " + std::to_string(task.attempt) + ")";
  return with_reason(text, task.reason);
}

std::string timed(double time, const std::string& text) {
  return fmt::format("{:7.2f} s  {}", time, text);
}

}  // namespace

Dialogue::Dialogue(Action action, std::vector<std::string> stop_devices, Parameters parameters)
    : action_(action), stop_devices_(std::move(stop_devices)), parameters_(std::move(parameters)), clear_(!moves()) {}

bool Dialogue::moves() const {
  return action_ == Action::kStart || action_ == Action::kHome || action_ == Action::kDrive;
}

void Dialogue::observe(const StopReport& report) {
  for (const std::string& device : stop_devices_) {
    if (device != report.device) continue;
    const auto known = devices_.find(device);
    const bool answered = known != devices_.end() && known->second.answers_us;
    if (for_devices() && report.answers_us && !answered) {
      lines_.push_back(device + (report.latched ? ": stopped" : ": released"));
    }
    // Another's later request does not take the answer back.
    if (!answered || report.answers_us) devices_[device] = report;
  }
}

void Dialogue::observe(const TaskReport& report, double now) {
  task_ = report;
  task_heard_ = now;
  if (for_devices() || report.answers != Answers::kUs) return;
  if (!followed_) followed_ = FollowedTask{report.time, {}};
  const auto& told = followed_->told;
  const bool changed = !told || told->phase != report.phase || told->reason != report.reason ||
                       told->attempt != report.attempt || told->target != report.target;
  const bool ending_tells = moves() && !under_way(report.phase);
  if (changed && !ending_tells) lines_.push_back(timed(report.time - followed_->since, describe(report)));
  followed_->told = report;
}

Step Dialogue::step(double now) {
  if (!began_) began_ = now;
  Step step;
  step.lines = std::exchange(lines_, {});
  const bool must_be_obeyed = action_ == Action::kStop || action_ == Action::kAbort;
  if (!two_.empty() && !must_be_obeyed) {
    step.ending = Ending{kExitRefused, two_ + ": end one of them, then " + parameters_.command + " reset"};
  } else if (for_devices()) {
    step.ending = devices_ending();
  } else if (followed_) {
    step.ending = task_ending();
  } else if (!clear_ && silent_devices().empty() && task_) {
    step.ending = obstacle();
    clear_ = !step.ending;
    began_ = now;
  }
  if (!step.ending) step.ending = silence(now);
  if (!step.ending && clear_ && !followed_) send_if_due(now, step);
  return step;
}

void Dialogue::send_if_due(double now, Step& step) {
  step.send = !sent_ || now - *sent_ >= parameters_.repeat;
  if (step.send) sent_ = now;
}

std::optional<Ending> Dialogue::devices_ending() const {
  if (!silent_devices().empty()) return std::nullopt;
  std::string others;
  for (const auto& [name, device] : devices_) {
    if (device.latched == (action_ == Action::kStop)) continue;
    others += (others.empty() ? "" : "; ") +
              with_reason(name + (device.latched ? " is still stopped" : " is not stopped"), device.reason);
  }
  if (!others.empty()) return Ending{kExitRefused, others};
  return Ending{kExitReached, action_ == Action::kStop ? "stopped: " + parameters_.command + " reset releases it"
                                                       : "released: nothing moves until it is told to (start or home)"};
}

// Why START, HOME or DRIVE must not be sent.
std::optional<Ending> Dialogue::obstacle() const {
  for (const auto& [name, device] : devices_) {
    if (!device.latched) continue;
    return Ending{kExitRefused, "stop is latched (" + with_reason(name, device.reason) + "): " + parameters_.command +
                                    " reset releases it"};
  }
  if (under_way(task_->phase)) {
    return Ending{kExitRefused,
                  "a task is under way (" + describe(*task_) + "): " + parameters_.command + " abort ends it"};
  }
  return std::nullopt;
}

std::optional<Ending> Dialogue::task_ending() const {
  if (action_ == Action::kAbort) return Ending{kExitReached, "no task is under way"};
  if (task_->answers == Answers::kAnother) return Ending{kExitRefused, "another command took the task over"};
  if (task_->answers == Answers::kNobody) return Ending{kExitRefused, "task-manager was restarted: the task is over"};
  if (under_way(task_->phase)) return std::nullopt;
  const bool reached = task_->phase == Phase::kHoldLifted || task_->phase == Phase::kDone;
  if (!reached) return Ending{kExitRefused, describe(*task_)};
  return Ending{kExitReached, timed(task_->time - followed_->since, describe(*task_))};
}

std::optional<Ending> Dialogue::silence(double now) const {
  const auto too_long = [&](double since) { return now - since >= parameters_.patience; };
  const std::string within = fmt::format(" within {:.4g} s", parameters_.patience);
  constexpr const char* kHint = " (it speaks once an image pair: do cameras, detector, locator and servo run?)";
  if (followed_) {
    if (!too_long(*task_heard_)) return std::nullopt;
    return Ending{kExitNoAnswer, "no answer from task-manager: no TASK_STATE any more" + within + kHint};
  }
  if (!too_long(*began_)) return std::nullopt;
  const std::string silent = silent_devices();
  if (for_devices()) {
    return Ending{kExitNoAnswer, "no answer from " + silent + within +
                                     (action_ == Action::kStop ? ": take its power away" : ": is its driver running?")};
  }
  if (moves() && !silent.empty()) {
    return Ending{kExitNoAnswer, "no answer from " + silent + ": no STOP_STATE" + within + ": is its driver running?"};
  }
  if (!task_) return Ending{kExitNoAnswer, "no answer from task-manager: no TASK_STATE" + within + kHint};
  return Ending{kExitNoAnswer, "no answer from task-manager: TASK_STATE does not echo the command" + within};
}

// The stop devices that have not said what is waited for; empty when all have.
std::string Dialogue::silent_devices() const {
  std::string names;
  for (const std::string& name : stop_devices_) {
    const auto found = devices_.find(name);
    const bool spoke = found != devices_.end() && (!for_devices() || found->second.answers_us);
    if (!spoke) names += (names.empty() ? "" : ", ") + name;
  }
  return names;
}

}  // namespace markservo::task
