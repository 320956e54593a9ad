#include "common/motion/mover_watch.hpp"

#include <cmath>

#include "common/time/seconds_between.hpp"

namespace markservo::motion {
namespace {

constexpr double kRecent_s = 1.0;

}  // namespace

std::string why_dropped(Word word) {
  switch (word) {
    case Word::kTaken:
    case Word::kReplaced:
    case Word::kAnew:
      return "";
    case Word::kLate:
      return "comes late or twice";
    case Word::kForeign:
      return "is of another session than its device's STOP_STATE";
    case Word::kConflict:
      return "is of one of two that claim to be the device";
  }
  return "is unknown";
}

std::string why_dropped(Heard heard) {
  switch (heard) {
    case Heard::kTaken:
    case Heard::kAnew:
      return "";
    case Heard::kLate:
      return "comes late or twice";
    case Heard::kWaits:
      return "is of a second writer, while the first still speaks";
    case Heard::kSecond:
      return "is of one of two writers";
  }
  return "is unknown";
}

Word MoverWatch::hear_stop_state(const Stamp& stamp, bool latched, const std::string& reason) {
  const Word word = trust_.hear_stop_state(stamp, latched);
  if (word == Word::kConflict) guard_.raise(trust_.conflict());
  if (!why_dropped(word).empty()) return word;
  latched_ = latched;
  stop_reason_ = reason;
  if (word != Word::kTaken) {
    for (auto& [channel, writer] : streams_) writer.forget_order();
  }
  if (word == Word::kReplaced && !latched) guard_.ask_again();
  if (guard_.hear_stop_state(latched, one_alone())) {
    trust_.settle();
    for (auto& [channel, writer] : streams_) writer.settle();
  }
  return word;
}

Word MoverWatch::hear_report(const std::string& channel, const Stamp& stamp) {
  const Word word = trust_.hear_report(channel, stamp);
  if (word == Word::kConflict) guard_.raise(trust_.conflict());
  if (word == Word::kForeign) stranger_at_ = now();
  if (word == Word::kAnew) {
    for (auto& [other, writer] : streams_) writer.forget_order();
  }
  return word;
}

Heard MoverWatch::hear_stream(const std::string& channel, const Stamp& stamp) {
  SoleWriter& writer = streams_.try_emplace(channel, channel).first->second;
  // An old recording, played to the bus, is nobody who writes now.
  const bool stranger = stamp.session != writer.session();
  if (stranger && now() != 0 && std::abs(seconds_between(stamp.utime, now())) > kRecent_s) return Heard::kLate;
  const Heard heard = writer.hear(stamp, now());
  if (heard == Heard::kSecond) guard_.raise(writer.words());
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
