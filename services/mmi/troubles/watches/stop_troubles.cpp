#include "services/mmi/troubles/watches/stop_troubles.hpp"

#include <markservo/channels.hpp>

namespace markservo::mmi {
namespace {

bool moves_something(const std::string& service) {
  return channels::has(channels::kJointCommand.writers, service) ||
         channels::has(channels::kBaseCommand.writers, service) || channels::has(channels::kTaskState.writers, service);
}

}  // namespace

StopTroubles::StopTroubles(const std::vector<std::string>& stop_devices, StopTroubleParameters parameters)
    : parameters_(parameters) {
  for (const std::string& device : stop_devices) devices_[device];
}

void StopTroubles::observe(const StopWord& word, double now) {
  const auto found = devices_.find(word.device);
  if (found == devices_.end()) return;
  Device& device = found->second;
  const bool was_latched = device.word && device.word->latched;
  if (word.latched && !was_latched) device.latched_since = {now, word.at};
  if (!word.latched || word.obeyed_a_request) in_use_ = true;
  device.word = word;
  device.last = {now, word.at};
}

void StopTroubles::observe(const ServiceWord& word, double now) {
  if (!moves_something(word.name)) return;
  if (!expected_since_ || now - mover_heard_ > parameters_.expects) expected_since_ = Since{now, word.at};
  mover_heard_ = now;
}

bool StopTroubles::is_silent(const Device& device, double now) const {
  if (device.word) return now - device.last.now > parameters_.silent;
  return expected_since_ && now - mover_heard_ <= parameters_.expects &&
         now - expected_since_->now > parameters_.first_word;
}

void StopTroubles::find(const Remedies& remedies, double now, Findings& found) const {
  for (const auto& [name, device] : devices_) {
    if (is_silent(device, now)) find_silent(name, device, remedies, found);
  }
  if (in_use_) find_latched(remedies, now, found);
}

void StopTroubles::find_silent(const std::string& name, const Device& device, const Remedies& remedies,
                               Findings& found) const {
  const Since since = device.word ? device.last : *expected_since_;
  const std::string text = device.word ? name + " does not say any more whether it is stopped"
                                       : name + " has not said yet whether it is stopped";
  found.push_back(
      {{TroubleCode::kStopDeviceSilent, name, since.utime, text, remedies.stop_device_silent()}, since.now});
}

void StopTroubles::find_latched(const Remedies& remedies, double now, Findings& found) const {
  Finding finding;
  Trouble& trouble = finding.trouble;
  std::string reasons;
  std::string last_reason;
  for (const auto& [name, device] : devices_) {
    if (!device.word || !device.word->latched || is_silent(device, now)) continue;
    const bool first = trouble.subject.empty();
    if (first || device.latched_since.now < finding.since) {
      finding.since = device.latched_since.now;
      trouble.since_utime = device.latched_since.utime;
    }
    trouble.subject += (first ? "" : ", ") + name;
    const std::string& reason = device.word->reason;
    if (!reason.empty() && reason != last_reason) reasons += (reasons.empty() ? "" : "; ") + reason;
    last_reason = reason;
  }
  if (trouble.subject.empty()) return;
  trouble.code = TroubleCode::kStopLatched;
  trouble.text = "stopped" + (reasons.empty() ? "" : ": " + reasons);
  trouble.remedy = remedies.stop_latched();
  found.push_back(std::move(finding));
}

}  // namespace markservo::mmi
