#include "common/motion/device_trust.hpp"

#include <algorithm>

#include "common/motion/sole_writer.hpp"
#include "common/time/seconds_between.hpp"

namespace markservo::motion {
namespace {

constexpr std::size_t kFormers = 16;            // earlier sessions; more restarts than that in a row prove nothing
constexpr std::int64_t kUnderWay_us = 100'000;  // a bridge or a bad link delivers no later
const char* const kStopState = "STOP_STATE";

}  // namespace

ReportHeard DeviceTrust::hear_stop_state(const Stamp& stamp, bool latched) {
  if (!trusted_) {
    const bool replaces = session_ != 0 && session_ != stamp.session;
    if (session_ != stamp.session) become(stamp);
    trusted_ = true;
    hear_own(kStopState, stamp);
    return replaces ? ReportHeard::kReplaced : ReportHeard::kTaken;
  }
  if (stamp.session == session_) return hear_own(kStopState, stamp);
  if (!conflict_.empty()) {
    hear_voice(stamp);
    if (spoke_alone()) {
      become(stamp);
      hear_own(kStopState, stamp);
      return ReportHeard::kReplaced;
    }
  }
  const ReportHeard heard = not_own(kStopState, stamp, true);
  if (heard != ReportHeard::kReplaced) return heard;
  if (!latched) return conflict_with(kStopState, stamp.session);
  formers_.push_back({session_, newest_utime_});
  if (formers_.size() > kFormers) formers_.pop_front();
  become(stamp);
  hear_own(kStopState, stamp);
  return ReportHeard::kReplaced;
}

ReportHeard DeviceTrust::hear_report(const std::string& channel, const Stamp& stamp) {
  if (session_ == 0) become(stamp);
  if (stamp.session == session_) return hear_own(channel, stamp);
  return not_own(channel, stamp, false);
}

ReportHeard DeviceTrust::hear_own(const std::string& channel, const Stamp& stamp) {
  switch (orders_[channel].hear(stamp)) {
    case Arrival::kLate:
      return ReportHeard::kLate;
    case Arrival::kDouble:
      return conflict_with(channel, stamp.session);
    case Arrival::kAnew:
      // The other channels' order and all times are of the former clock.
      orders_.clear();
      orders_[channel].hear(stamp);
      newest_utime_ = stamp.utime;
      hear_voice(stamp);
      return ReportHeard::kAnew;
    case Arrival::kNext:
      break;
  }
  newest_utime_ = std::max(newest_utime_, stamp.utime);
  hear_voice(stamp);
  return ReportHeard::kTaken;
}

// `claims`: it says to be the device; kReplaced when a stranger does.
ReportHeard DeviceTrust::not_own(const std::string& channel, const Stamp& stamp, bool claims) {
  const auto former = std::find_if(formers_.begin(), formers_.end(),
                                   [&stamp](const Former& one) { return one.session == stamp.session; });
  if (former != formers_.end()) {
    // What was under way when it was replaced may arrive after its successor's first word.
    if (stamp.utime <= former->newest_utime + kUnderWay_us) return ReportHeard::kLate;
    hear_voice(stamp);
    return conflict_with(channel, stamp.session);
  }
  hear_voice(stamp);
  if (claims) return ReportHeard::kReplaced;
  foreign_session_ = stamp.session;
  ++foreign_count_;
  return ReportHeard::kForeign;
}

ReportHeard DeviceTrust::conflict_with(const std::string& channel, std::int64_t session) {
  foreign_session_ = session;
  conflict_ = two_write(channel + " of " + device_, session_, session);
  return ReportHeard::kConflict;
}

void DeviceTrust::become(const Stamp& stamp) {
  session_ = stamp.session;
  orders_.clear();
  newest_utime_ = 0;
}

void DeviceTrust::hear_voice(const Stamp& stamp) {
  if (stamp.session != voice_.session || stamp.utime < voice_.since) voice_ = {stamp.session, stamp.utime, stamp.utime};
  voice_.newest = std::max(voice_.newest, stamp.utime);
}

bool DeviceTrust::spoke_alone() const {
  return seconds_between(voice_.since, voice_.newest) >= kAlone_s;
}

bool DeviceTrust::alone() const {
  return voice_.session == session_ && spoke_alone();
}

void DeviceTrust::settle() {
  conflict_.clear();
  formers_.clear();
  foreign_session_ = 0;
}

}  // namespace markservo::motion
