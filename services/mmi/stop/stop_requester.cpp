#include "services/mmi/stop/stop_requester.hpp"

#include <algorithm>

#include "common/time/seconds_between.hpp"

namespace markservo::mmi {
namespace {

constexpr std::size_t kResetsKept = 100;  // whoever sends many

}  // namespace

const char* name_of(StopAnswer answer) {
  switch (answer) {
    case StopAnswer::kIdle:
      break;
    case StopAnswer::kRequested:
      return "requested";
    case StopAnswer::kAcknowledged:
      return "acknowledged";
    case StopAnswer::kSilent:
      return "silent";
  }
  return "idle";
}

StopRequester::StopRequester(std::vector<std::string> stop_devices, StopParameters parameters)
    : stop_devices_(std::move(stop_devices)), parameters_(parameters), sender_(stop_devices_) {
  for (const std::string& device : stop_devices_) devices_[device];
}

void StopRequester::request(const std::string& reason, double now) {
  if (state_ == StopAnswer::kRequested) return;
  state_ = StopAnswer::kRequested;
  request_id_ = ++numbers_;
  reason_ = reason;
  requested_ = now;
  requested_utime_ = sender_.stamp(motion::CommandKind::kStop).value_or(0);
  sent_.reset();
  for (auto& [name, device] : devices_) device.echo_utime.reset();
}

std::optional<StopToSend> StopRequester::due(double now) {
  if (state_ != StopAnswer::kRequested) return std::nullopt;
  if (sent_ && now - *sent_ < parameters_.repeat) return std::nullopt;
  sent_ = now;
  return StopToSend{request_id_, sender_.stamp(motion::CommandKind::kStop).value_or(0), reason_};
}

void StopRequester::observe(const task::StopReport& report, std::int64_t utime, double now) {
  const auto found = devices_.find(report.device);
  if (found == devices_.end()) return;
  Device& device = found->second;
  device.report = report;
  device.heard = now;
  sender_.observe_stop_state(report.device, utime);
  const bool began_anew = seconds_between(utime, requested_utime_) > parameters_.clock_jump;
  if (began_anew) requested_utime_ = utime;
  if (state_ == StopAnswer::kIdle) return;
  if (device.echo_utime && !report.latched && utime > *device.echo_utime) {
    if (state_ == StopAnswer::kAcknowledged) return end();
    device.echo_utime.reset();  // others have not echoed yet: it may be a driver that began anew
  }
  // Another's later request does not take the answer back.
  if (!device.echo_utime && report.answers_us && report.latched) device.echo_utime = utime;
  const bool all =
      std::all_of(devices_.begin(), devices_.end(), [](const auto& one) { return one.second.echo_utime.has_value(); });
  if (all) state_ = StopAnswer::kAcknowledged;
}

void StopRequester::observe(const HeardReset& reset) {
  if (state_ != StopAnswer::kIdle && is_later(reset)) end();
  const auto request = std::make_pair(reset.session, reset.request_id);
  if (std::find(earlier_resets_.begin(), earlier_resets_.end(), request) != earlier_resets_.end()) return;
  earlier_resets_.push_back(request);
  if (earlier_resets_.size() > kResetsKept) earlier_resets_.pop_front();
}

// A repeat of one that was sent before the request is none, however its sender stamps it.
bool StopRequester::is_later(const HeardReset& reset) const {
  const auto request = std::make_pair(reset.session, reset.request_id);
  const bool is_repeat = std::find(earlier_resets_.begin(), earlier_resets_.end(), request) != earlier_resets_.end();
  return !is_repeat && reset.utime > requested_utime_;
}

void StopRequester::end() {
  state_ = StopAnswer::kIdle;
}

StopAnswer StopRequester::answer_of(const Device& device, double now) const {
  if (state_ == StopAnswer::kIdle) {
    const bool speaks = device.report && now - device.heard <= parameters_.gone;
    return speaks ? StopAnswer::kIdle : StopAnswer::kSilent;
  }
  if (device.echo_utime) return StopAnswer::kAcknowledged;
  return now - requested_ >= parameters_.silent ? StopAnswer::kSilent : StopAnswer::kRequested;
}

StopView StopRequester::view(double now) const {
  StopView view;
  view.state = state_;
  view.request_id = request_id_;
  for (const std::string& name : stop_devices_) {
    const Device& device = devices_.at(name);
    StopDeviceView seen;
    seen.device = name;
    seen.answer = answer_of(device, now);
    if (device.report) {
      seen.latched = device.report->latched;
      seen.reason = device.report->reason;
    }
    view.devices.push_back(std::move(seen));
  }
  return view;
}

}  // namespace markservo::mmi
