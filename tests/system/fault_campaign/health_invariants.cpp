// I7 and I8: what services say of themselves, and whether all is as before when the fault is gone.

#include <algorithm>
#include <cmath>
#include <deque>
#include <map>
#include <optional>
#include <set>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/invariants.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

// What each service cannot work without, and what it writes all the time.
struct Needs {
  std::vector<std::string> hears;
  std::vector<std::string> speaks;
};

const std::map<std::string, Needs>& needs() {
  static const std::map<std::string, Needs> all = {
      {"simulator", {{}, {"JOINT_STATE", "WHEEL_ODOMETRY"}}},
      {"mark-detector", {{"STEREO_FRAME"}, {"MARK_DETECTION"}}},
      {"target-locator", {{"MARK_DETECTION"}, {"TARGET_POSE"}}},
      {"visual-servo", {{"TARGET_POSE", "JOINT_STATE"}, {"JOINT_COMMAND"}}},
      {"task-manager", {{"SERVO_STATUS"}, {"TASK_STATE"}}},
      {"rfid-localizer", {{"WHEEL_ODOMETRY"}, {"ROBOT_POSE"}}},
      {"base-navigator", {{"ROBOT_POSE", "WHEEL_ODOMETRY"}, {"BASE_COMMAND"}}},
  };
  return all;
}

// As scripts/stack understands a service's word.
bool is_ready(const std::string& state) {
  return state != "starting" && state != "waiting" && state != "stale";
}

// By pid: what its own words told.
using Words = std::map<int, std::vector<const Heard<ServiceStatus>*>>;

Words words_of_service(const Timeline& timeline, const std::string& service) {
  Words words;
  for (const auto& heard : timeline.statuses) {
    if (heard.foreign || heard.message.name != service || !timeline.is(service, heard.message.session)) continue;
    words[heard.message.pid].push_back(&heard);
  }
  return words;
}

std::int64_t received(const ServiceStatus& status, const std::string& channel) {
  for (const auto& counted : status.channels) {
    if (counted.channel == channel) return counted.received;
  }
  return 0;
}

// The stack's own messages on a channel within [from, to].
bool spoken(const Timeline& timeline, const std::string& channel, std::int64_t from, std::int64_t to) {
  const auto found = timeline.traffic.find(channel);
  if (found == timeline.traffic.end()) return false;
  auto first = std::lower_bound(found->second.begin(), found->second.end(), from,
                                [](const Traffic& traffic, std::int64_t t) { return traffic.t < t; });
  for (; first != found->second.end() && first->t <= to; ++first) {
    if (!first->foreign) return true;
  }
  return false;
}

void judge_words(const Timeline& timeline, const std::string& service, const Bars& bars, Verdict& verdict) {
  const Needs& need = needs().at(service);
  const auto silence_us = static_cast<std::int64_t>((bars.silence + bars.status_slack) * 1e6);
  for (const auto& [pid, words] : words_of_service(timeline, service)) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const auto& now = *words[i];
      // What was said so long ago, or longer.
      std::size_t before = i;
      while (before > 0 && now.t - words[before]->t < silence_us) --before;
      const auto& then = *words[before];
      if (now.t - then.t < silence_us) continue;
      ++verdict.judged;
      if (!is_ready(now.message.state)) continue;
      for (const std::string& channel : need.hears) {
        if (received(now.message, channel) > received(then.message, channel)) continue;
        note(verdict, now.t,
             text("%s says ready, and has taken no %s for %.1f s", service.c_str(), channel.c_str(),
                  seconds_between(then.t, now.t)));
      }
      for (const std::string& channel : need.speaks) {
        if (spoken(timeline, channel, now.t - silence_us, now.t)) continue;
        note(verdict, now.t,
             text("%s says ready, and has sent no %s for %.1f s", service.c_str(), channel.c_str(),
                  bars.silence + bars.status_slack));
      }
    }
  }
}

// A process that stands still for so long is not left alone: nobody would ever know.
void judge_hangs(const Timeline& timeline, const std::string& service, const Bars& bars, Verdict& verdict) {
  const auto found = timeline.processes.find(service);
  if (found == timeline.processes.end()) return;
  std::optional<ProcessSample> since;
  for (const ProcessSample& sample : found->second) {
    const bool stopped = sample.state == 'T';
    if (since && (!stopped || sample.pid != since->pid)) since.reset();
    if (!stopped) continue;
    if (!since) since = sample;
    const double seconds = seconds_between(since->t, sample.t);
    if (seconds < bars.silence) continue;
    ++verdict.judged;
    if (seconds <= bars.silence + bars.status_slack) continue;
    note(verdict, sample.t,
         text("%s (process %d) has hung for %.1f s and runs on as if nothing were", service.c_str(), sample.pid,
              seconds));
    return;
  }
}

// ---- I8

std::set<std::string> ready_before(const Timeline& timeline) {
  std::set<std::string> ready;
  for (const auto& heard : timeline.statuses) {
    if (heard.t >= timeline.first_strike()) break;
    if (heard.foreign || !timeline.is(heard.message.name, heard.message.session)) continue;
    if (is_ready(heard.message.state)) ready.insert(heard.message.name);
  }
  return ready;
}

void judge_readiness(const Timeline& timeline, const Bars& bars, Verdict& verdict) {
  const std::int64_t gone = timeline.faults_gone();
  const std::int64_t end = std::min(timeline.ended_at, gone + static_cast<std::int64_t>(bars.recovery * 1e6));
  for (const std::string& service : ready_before(timeline)) {
    ++verdict.judged;
    const Heard<ServiceStatus>* last = nullptr;
    const Heard<ServiceStatus>* ready = nullptr;
    for (const auto& heard : timeline.statuses) {
      const bool own = !heard.foreign && heard.message.name == service && timeline.is(service, heard.message.session);
      if (!own || heard.t <= gone || heard.t > end) continue;
      last = &heard;
      if (is_ready(heard.message.state)) ready = &heard;
    }
    // A goal that comes a little late on a busy machine is told as stale now and then.
    if (ready != nullptr && seconds_between(ready->t, end) <= bars.ready_age) continue;
    note(verdict, end,
         last == nullptr
             ? text("%s has said nothing in %.1f s since the fault was gone", service.c_str(),
                    seconds_between(gone, end))
             : text("%s says %s %.1f s after the fault was gone: %.200s", service.c_str(), last->message.state.c_str(),
                    seconds_between(gone, last->t), last->message.reason.c_str()));
  }
}

void judge_memory(const Timeline& timeline, const Bars& bars, Verdict& verdict) {
  const std::int64_t strike = timeline.first_strike();
  for (const auto& [service, samples] : timeline.processes) {
    double before = 0.0;
    double after = 0.0;
    for (const ProcessSample& sample : samples) {
      if (sample.t < strike) before = std::max(before, sample.rss_mb);
      if (sample.t > timeline.faults_gone()) after = sample.rss_mb;
    }
    if (before == 0.0 || after == 0.0) continue;
    ++verdict.judged;
    if (after - before > bars.memory_mb)
      note(verdict, timeline.ended_at, text("%s had %.1f MB and has %.1f MB", service.c_str(), before, after));
  }
}

// A channel's messages of the stack within [from, to).
struct Load {
  double bytes = 0.0;
  double messages = 0.0;
  double size() const { return messages > 0.0 ? bytes / messages : 0.0; }
};

Load load_of(const std::vector<Traffic>& traffic, std::int64_t from, std::int64_t to) {
  Load load;
  for (const Traffic& one : traffic) {
    if (one.foreign || one.t < from || one.t >= to) continue;
    load.bytes += static_cast<double>(one.size);
    load.messages += 1.0;
  }
  return load;
}

// Whether `now` messages a second are more than scatter explains, where there were `then`.
bool many(double then, double now, const Bars& bars) {
  return now > bars.rate_factor * then + bars.rate_floor + (then == 0.0 ? bars.rate_floor : 0.0);
}

// By channel, since rates are the machine's: how large messages are, and how many come in the world's time.
void judge_bytes(const Timeline& timeline, const Bars& bars, Verdict& verdict) {
  constexpr std::int64_t kLongBefore_us = 6'000'000;
  static const std::set<std::string> kOwn = {"STOP", "TASK_COMMAND", "SIM_CONTROL"};
  // What is seen decides how large these are.
  static const std::set<std::string> kPictures = {"STEREO_FRAME", "MARK_DETECTION", "STEREO_MATCHES"};
  const std::int64_t strike = timeline.first_strike();
  const std::int64_t calm = timeline.faults_gone() + static_cast<std::int64_t>(bars.calm * 1e6);
  const std::int64_t before = strike - kLongBefore_us;
  const double seconds_before = timeline.clock.at(strike) - timeline.clock.at(before);
  const double seconds_after = timeline.clock.at(timeline.ended_at) - timeline.clock.at(calm);
  if (seconds_before < 1.0 || seconds_after < 1.0) return;
  for (const auto& [channel, traffic] : timeline.traffic) {
    if (kOwn.count(channel) > 0 || kPictures.count(channel) > 0) continue;
    if (channel.rfind("SIM_", 0) == 0) continue;  // no robot has them
    const Load then = load_of(traffic, before, strike);
    const Load now = load_of(traffic, calm, timeline.ended_at);
    if (now.messages == 0.0) continue;
    ++verdict.judged;
    if (then.messages > 0.0 && now.size() > then.size() * (1.0 + bars.bytes_share) + bars.bytes_floor) {
      note(verdict, timeline.ended_at,
           text("%s: messages of %.0f bytes before, of %.0f bytes after", channel.c_str(), then.size(), now.size()));
    }
    // Some are sent by the world's time, some by the hour; a busy machine slows the one and not the other.
    const bool more_by_world = many(then.messages / seconds_before, now.messages / seconds_after, bars);
    const bool more_by_hour = many(then.messages / seconds_between(before, strike),
                                   now.messages / seconds_between(calm, timeline.ended_at), bars);
    if (!more_by_world || !more_by_hour) continue;
    note(verdict, timeline.ended_at,
         text("%s: %.1f messages/s before, %.1f after", channel.c_str(), then.messages / seconds_before,
              now.messages / seconds_after));
  }
}

}  // namespace

Verdict deaf_or_mute_is_not_ready(const Timeline& timeline, const Bars& bars) {
  Verdict verdict;
  for (const auto& [service, need] : needs()) {
    judge_words(timeline, service, bars, verdict);
    judge_hangs(timeline, service, bars, verdict);
  }
  return verdict;
}

Verdict recovers_unaided(const Timeline& timeline, const Bars& bars) {
  Verdict verdict;
  bool struck = false;
  for (const Fault& fault : timeline.faults) struck = struck || fault.struck_at > 0;
  if (!struck) return verdict;
  judge_readiness(timeline, bars, verdict);
  judge_memory(timeline, bars, verdict);
  judge_bytes(timeline, bars, verdict);
  return verdict;
}

}  // namespace markservo::campaign
