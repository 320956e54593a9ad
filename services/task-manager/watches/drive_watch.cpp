#include "services/task-manager/watches/drive_watch.hpp"

#include <fmt/format.h>

#include "common/time/seconds_between.hpp"

namespace markservo::task_manager {
namespace {

std::string with_reason(const std::string& text, const std::string& reason) {
  return reason.empty() ? text : text + ": " + reason;
}

std::string within(const char* text, double seconds) {
  return fmt::format("{} within {:.1f} s", text, seconds);
}

// base-navigator has not said for too long how the goal stands: why.
DriveReport silence(const BaseReport* answer, double timeout) {
  if (answer == nullptr) {
    return {DriveState::kFailed, within("base-navigator does not answer: no BASE_STATUS of this goal", timeout)};
  }
  if (answer->state == BaseState::kStopped) {
    return {DriveState::kStopped, with_reason("base-navigator is stopped", answer->reason)};
  }
  return {DriveState::kFailed, with_reason("the base holds for want of fresh input", answer->reason)};
}

}  // namespace

DriveReport watch_drive(std::int64_t goal_id, const Input& input, std::int64_t now, const DriveParameters& parameters,
                        DriveProgress& progress) {
  const BaseReport* answer = input.base && input.base->goal_id == goal_id ? &*input.base : nullptr;
  // One that has fallen silent leaves its last word behind.
  if (answer != nullptr && seconds_between(answer->utime, input.utime) > parameters.silent_timeout) answer = nullptr;
  const BaseState state = answer != nullptr ? answer->state : BaseState::kStale;
  if (state == BaseState::kArrived) return {DriveState::kArrived, ""};
  if (state == BaseState::kHold && !answer->reason.empty()) {
    return {DriveState::kFailed, "base-navigator refuses the goal: " + answer->reason};
  }

  const bool stuck = state == BaseState::kBlocked || state == BaseState::kLost;
  if (state == BaseState::kDriving || stuck) progress.answered = now;
  if (state == BaseState::kDriving) progress.driving = now;
  if (seconds_between(progress.answered, now) > parameters.silent_timeout) {
    return silence(answer, parameters.silent_timeout);
  }
  const char* what =
      state == BaseState::kLost ? "the base does not know where it is" : "something blocks the base's way";
  if (stuck && seconds_between(progress.driving, now) > parameters.stuck_timeout) {
    return {DriveState::kFailed, with_reason(what, answer->reason)};
  }
  if (seconds_between(progress.since, now) > parameters.timeout) {
    return {DriveState::kFailed, within("the base did not arrive", parameters.timeout)};
  }
  if (stuck) return {DriveState::kWaiting, what};
  return {};
}

}  // namespace markservo::task_manager
