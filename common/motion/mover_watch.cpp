#include "common/motion/mover_watch.hpp"

#include <cmath>

#include "common/time/seconds_between.hpp"

namespace markservo::motion {
namespace {

constexpr double kRecent_s = 1.0;

}  // namespace

std::string why_dropped(ReportHeard heard) {
  switch (heard) {
    case ReportHeard::kTaken:
    case ReportHeard::kReplaced:
    case ReportHeard::kAnew:
      return "";
    case ReportHeard::kLate:
      return "comes late or twice";
    case ReportHeard::kForeign:
      return "is of another session than its device's STOP_STATE";
    case ReportHeard::kConflict:
      return "is of one of two that claim to be the device";
  }
  return "is unknown";
}

std::string why_dropped(StreamHeard heard) {
  switch (heard) {
    case StreamHeard::kTaken:
    case StreamHeard::kAnew:
      return "";
    case StreamHeard::kLate:
      return "comes late or twice";
    case StreamHeard::kWaits:
      return "is of a second writer, while the first still speaks";
    case StreamHeard::kSecond:
      return "is of one of two writers";
  }
  return "is unknown";
}

ReportHeard MoverWatch::hear_stop_state(const Stamp& stamp, bool latched, const std::string& reason) {
  const ReportHeard heard = trust_.hear_stop_state(stamp, latched);
  if (heard == ReportHeard::kConflict) guard_.raise(trust_.conflict());
  if (!why_dropped(heard).empty()) return heard;
  latched_ = latched;
  stop_reason_ = reason;
  if (heard != ReportHeard::kTaken) {
    for (auto& [channel, writer] : streams_) writer.forget_order();
  }
  if (heard == ReportHeard::kReplaced && !latched) guard_.ask_again();
  if (guard_.hear_stop_state(latched, one_alone())) {
    trust_.settle();
    for (auto& [channel, writer] : streams_) writer.settle();
  }
  return heard;
}

ReportHeard MoverWatch::hear_report(const std::string& channel, const Stamp& stamp) {
  const ReportHeard heard = trust_.hear_report(channel, stamp);
  if (heard == ReportHeard::kConflict) guard_.raise(trust_.conflict());
  if (heard == ReportHeard::kForeign) stranger_at_ = now();
  if (heard == ReportHeard::kAnew) {
    for (auto& [other, writer] : streams_) writer.forget_order();
  }
  return heard;
}

StreamHeard MoverWatch::hear_stream(const std::string& channel, const Stamp& stamp) {
  SoleWriter& writer = streams_.try_emplace(channel, channel).first->second;
  // An old recording, played to the bus, is nobody who writes now.
  const bool stranger = stamp.session != writer.session();
  if (stranger && now() != 0 && std::abs(seconds_between(stamp.utime, now())) > kRecent_s) return StreamHeard::kLate;
  const StreamHeard heard = writer.hear(stamp, now());
  if (heard == StreamHeard::kSecond) guard_.raise(writer.words());
  return heard;
}

bool MoverWatch::one_alone() const {
  if (!trust_.alone()) return false;
  for (const auto& [channel, writer] : streams_) {
    if (!writer.alone(now())) return false;
  }
  return true;
}

std::string MoverWatch::stranger() const {
  if (stranger_at_ < 0 || std::abs(seconds_between(stranger_at_, now())) > kRecent_s) return "";
  return "another writes for the " + device_ + ": session " + std::to_string(trust_.foreign()) + " is not heard, " +
         std::to_string(trust_.session()) + " is";
}

}  // namespace markservo::motion
