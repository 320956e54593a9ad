// I8: the bus's load when the faults are gone, beside what it was before them.

#include <algorithm>
#include <set>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/invariants.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

// What asks somebody for something: spoken now and then, and not by the world's time.
const std::set<std::string>& asking() {
  static const std::set<std::string> channels = {"STOP", "TASK_COMMAND"};
  return channels;
}

// The small channels that the stack speaks on by the world's time. What is seen decides how large pictures and what is
// told of them are; no robot has the simulator's own.
bool is_judged(const std::string& channel) {
  static const std::set<std::string> kPictures = {"STEREO_FRAME", "MARK_DETECTION", "STEREO_MATCHES"};
  return asking().count(channel) == 0 && kPictures.count(channel) == 0 && channel != "SERVICE_STATUS" &&
         channel != "LCM_SELF_TEST" && channel.rfind("SIM_", 0) != 0;
}

// A channel's messages of the stack within [from, to).
struct Load {
  double bytes = 0.0;  // but texts
  double messages = 0.0;
  double longest = 0.0;  // bytes of the longest text
  double size() const { return messages > 0.0 ? bytes / messages : 0.0; }
};

Load load_of(const std::vector<Traffic>& traffic, std::int64_t from, std::int64_t to) {
  Load load;
  for (const Traffic& one : traffic) {
    if (one.foreign || one.t < from || one.t >= to) continue;
    load.bytes += static_cast<double>(one.size - one.texts);
    load.messages += 1.0;
    load.longest = std::max(load.longest, static_cast<double>(one.longest));
  }
  return load;
}

struct Span {
  std::int64_t from = 0;  // us
  std::int64_t to = 0;
  double world = 0.0;  // s
  double hour = 0.0;   // s
};

Span span_of(const Timeline& timeline, std::int64_t from, std::int64_t to) {
  return {from, to, timeline.clock.at(to) - timeline.clock.at(from), seconds_between(from, to)};
}

void judge_channel(const Timeline& timeline, const std::string& channel, const Load& then, const Load& now,
                   const Span& before, const Span& after, const Bars& bars, Verdict& verdict) {
  const double more = 1.0 + bars.bytes_share;
  const double floor = channel == "RFID_TAG_HITS" ? bars.varied_floor : bars.bytes_floor;
  if (then.messages > 0.0 && now.size() > then.size() * more + floor) {
    note(verdict, timeline.ended_at,
         text("%s: messages of %.0f bytes but texts before, of %.0f bytes after", channel.c_str(), then.size(),
              now.size()));
  }
  // Goals are sent at 5 Hz while a task is under way, and there may have been none before.
  constexpr double kGoals = 6.0;
  const double rare = channel == "SERVO_GOAL" || channel == "BASE_GOAL" ? kGoals : bars.rate_floor;
  // Some are sent by the world's time, some by the hour; a busy machine slows the one and not the other.
  const bool by_world = now.messages / after.world > more * then.messages / before.world + rare;
  const bool by_hour = now.messages / after.hour > more * then.messages / before.hour + rare;
  if (!by_world || !by_hour) return;
  note(verdict, timeline.ended_at,
       text("%s: %.1f messages/s before, %.1f after", channel.c_str(), then.messages / before.world,
            now.messages / after.world));
}

// Texts are bounded whatever came, and nobody asks for something for ever, or changes his word all the time.
void judge_words(const Timeline& timeline, const std::string& channel, const Load& now, const Span& after,
                 const Bars& bars, Verdict& verdict) {
  if (now.longest > bars.longest_text) {
    note(verdict, timeline.ended_at, text("%s: a text of %.0f bytes", channel.c_str(), now.longest));
  }
  constexpr double kFew = 3.0;
  if (asking().count(channel) > 0 && now.messages > kFew + bars.asks_rate * after.hour) {
    note(verdict, timeline.ended_at,
         text("%s: the stack itself sent %.0f in %.1f s after the faults", channel.c_str(), now.messages, after.hour));
  }
  const auto services = static_cast<double>(std::max<std::size_t>(1, timeline.sessions.size()));
  if (channel == "SERVICE_STATUS" && now.messages > services * (bars.words_rate * after.hour + bars.words_of_change)) {
    note(
        verdict, timeline.ended_at,
        text("SERVICE_STATUS: %.0f services sent %.0f in %.1f s after the faults", services, now.messages, after.hour));
  }
}

}  // namespace

// By the world's second, since a machine may be slow: then rates and sizes of a healthy stack are the same to 2% in any
// of its states, but for goals, which are few, and texts.
void judge_load(const Timeline& timeline, std::int64_t ready_since, const Bars& bars, Verdict& verdict) {
  constexpr std::int64_t kLongBefore_us = 6'000'000;
  constexpr double kShortest_s = 1.0;
  const std::int64_t strike = timeline.first_strike();
  const std::int64_t calm = timeline.faults_gone() + static_cast<std::int64_t>(bars.calm * 1e6);
  const Span before = span_of(timeline, std::max(ready_since, strike - kLongBefore_us), strike);
  const Span after = span_of(timeline, calm, timeline.ended_at);
  const bool known = before.world >= kShortest_s && after.world >= kShortest_s;
  double all_then = 0.0;
  double all_now = 0.0;
  for (const auto& [channel, traffic] : timeline.traffic) {
    const Load now = load_of(traffic, after.from, after.to);
    if (now.messages == 0.0) continue;
    ++verdict.judged;
    judge_words(timeline, channel, now, after, bars, verdict);
    if (!known || !is_judged(channel)) continue;
    const Load then = load_of(traffic, before.from, before.to);
    all_then += then.bytes / before.world;
    all_now += now.bytes / after.world;
    judge_channel(timeline, channel, then, now, before, after, bars, verdict);
  }
  if (!known || all_then == 0.0 || all_now <= all_then * (1.0 + bars.bytes_share)) return;
  note(verdict, timeline.ended_at,
       text("the bus: %.0f bytes but texts a second of the world before, %.0f after", all_then, all_now));
}

}  // namespace markservo::campaign
