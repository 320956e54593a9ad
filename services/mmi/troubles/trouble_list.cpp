#include "services/mmi/troubles/trouble_list.hpp"

#include <algorithm>
#include <tuple>

namespace markservo::mmi {

double TroubleList::begin_of(TroubleCode code) const {
  switch (code) {
    case TroubleCode::kProcessDead:
    case TroubleCode::kProcessHung:
      return parameters_.process;
    case TroubleCode::kMarkUnseen:
    case TroubleCode::kHandUnseen:
      return parameters_.mark;
    case TroubleCode::kPoseLost:
    case TroubleCode::kBaseBlocked:
      return parameters_.base;
    case TroubleCode::kRecordingEnded:
      return parameters_.recording;
    case TroubleCode::kMmiLost:
    case TroubleCode::kStopDeviceSilent:
    case TroubleCode::kSecondWriter:
    case TroubleCode::kClockAhead:
    case TroubleCode::kMessagesLost:
    case TroubleCode::kCameraSilent:
    case TroubleCode::kStopLatched:
    case TroubleCode::kTargetRefused:
      break;
  }
  return 0.0;
}

double TroubleList::end_of(TroubleCode code) const {
  return code == TroubleCode::kMessagesLost ? parameters_.loss_end : parameters_.end;
}

const std::vector<Trouble>& TroubleList::step(const Findings& findings, double now) {
  for (const Finding& finding : findings) {
    const Trouble& trouble = finding.trouble;
    const auto key = identity_of(trouble);
    const auto known = shown_.find(key);
    if (known == shown_.end()) {
      if (now - finding.since >= begin_of(trouble.code)) shown_[key] = {trouble, finding.since, now};
      continue;
    }
    Shown& shown = known->second;
    const std::int64_t since_utime = shown.trouble.since_utime;
    shown.trouble = trouble;
    shown.trouble.since_utime = since_utime;
    shown.last = now;
  }
  for (auto shown = shown_.begin(); shown != shown_.end();) {
    const bool is_over = now - shown->second.last > end_of(shown->first.first);
    shown = is_over ? shown_.erase(shown) : std::next(shown);
  }
  std::vector<const Shown*> order;
  order.reserve(shown_.size());
  for (const auto& [key, shown] : shown_) order.push_back(&shown);
  std::stable_sort(order.begin(), order.end(), [](const Shown* a, const Shown* b) {
    return std::tie(a->trouble.code, a->since) < std::tie(b->trouble.code, b->since);
  });
  troubles_.clear();
  for (const Shown* shown : order) troubles_.push_back(shown->trouble);
  return troubles_;
}

}  // namespace markservo::mmi
