#include "services/mmi/troubles/watches/clock_troubles.hpp"

#include <fmt/core.h>

#include "common/bus/clock_tolerance.hpp"
#include "common/time/seconds_between.hpp"
#include "services/mmi/troubles/watches/service_reason.hpp"

namespace markservo::mmi {
namespace {

std::string ahead_text(double seconds) {
  return seconds < 10.0 ? fmt::format("{:.1g} s", seconds) : fmt::format("{:.0f} s", seconds);
}

}  // namespace

void ClockTroubles::observe(const AnyWord& word, double now) {
  const double ahead = seconds_between(word.at, word.utime);
  if (ahead <= 1e-6 * static_cast<double>(bus::kClockTolerance_us)) {
    senders_.erase(word.session);
    return;
  }
  Sender* sender = known_or_new(senders_, word.session, now);
  if (sender == nullptr) return;
  if (sender->in_a_row == 0 || now - sender->heard > parameters_.window) *sender = {{now, word.at}, 0, 0.0, {}, now};
  if (sender->in_a_row < parameters_.messages) ++sender->in_a_row;
  sender->ahead = ahead;
  sender->channel = word.channel;
  sender->heard = now;
}

void ClockTroubles::observe(const ServiceWord& word, double now) {
  if (!tells_of_a_clock(word.reason)) {
    readers_.erase(word.name);
    return;
  }
  Reader* reader = known_or_new(readers_, word.name, now);
  if (reader == nullptr) return;
  if (reader->reason.empty() || now - reader->heard > parameters_.word) reader->since = {now, word.at};
  reader->reason = word.reason;
  reader->heard = now;
}

void ClockTroubles::find(const SessionNames& names, const Remedies& remedies, double now, Findings& found) const {
  bool found_here = false;
  for (const auto& [session, sender] : senders_) {
    if (sender.in_a_row < parameters_.messages || now - sender.heard > parameters_.window) continue;
    found_here = true;
    const std::string service = names.service(session);
    const std::string text = fmt::format("the clock of {} is {} ahead: all that it says is refused",
                                         names.words(session), ahead_text(sender.ahead));
    found.push_back({{TroubleCode::kClockAhead, service.empty() ? sender.channel : service, sender.since.utime, text,
                      remedies.clock_ahead()},
                     sender.since.now});
  }
  if (found_here) return;
  for (const auto& [name, reader] : readers_) {
    if (now - reader.heard > parameters_.word) continue;
    found.push_back({{TroubleCode::kClockAhead, channel_in(reader.reason), reader.since.utime,
                      name + " refuses what comes from the future: " + reader.reason, remedies.clock_ahead()},
                     reader.since.now});
  }
}

}  // namespace markservo::mmi
