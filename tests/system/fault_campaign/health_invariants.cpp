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

// What each service says that it needs (its bus.need()), and what it writes all the time.
struct Needs {
  std::vector<std::string> hears;
  std::vector<std::string> speaks;
};

const std::map<std::string, Needs>& needs() {
  static const std::map<std::string, Needs> all = {
      {"simulator", {{}, {"JOINT_STATE", "STOP_STATE", "WHEEL_ODOMETRY", "SONAR_SCAN"}}},
      {"mark-detector", {{"STEREO_FRAME"}, {"MARK_DETECTION"}}},
      {"target-locator", {{"MARK_DETECTION"}, {"TARGET_POSE"}}},
      {"visual-servo", {{"TARGET_POSE", "JOINT_STATE", "STOP_STATE"}, {"JOINT_COMMAND", "SERVO_STATUS"}}},
      {"task-manager", {{"SERVO_STATUS", "TARGET_POSE", "JOINT_STATE", "STOP_STATE"}, {"TASK_STATE"}}},
      {"rfid-localizer", {{"RFID_TAG_HITS"}, {"ROBOT_POSE"}}},
      {"base-navigator",
       {{"WHEEL_ODOMETRY", "ROBOT_POSE", "SONAR_SCAN", "STOP_STATE"}, {"BASE_COMMAND", "BASE_STATUS"}}},
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

// When nothing at all was heard of the stack for longer than `bars.no_network`: then there was no network, by which
// nobody is deaf or mute who waits for it.
std::vector<std::pair<std::int64_t, std::int64_t>> without_network(const Timeline& timeline, const Bars& bars) {
  std::vector<std::int64_t> times;
  for (const auto& [channel, traffic] : timeline.traffic) {
    for (const Traffic& one : traffic) {
      if (!one.foreign) times.push_back(one.t);
    }
  }
  std::sort(times.begin(), times.end());
  std::vector<std::pair<std::int64_t, std::int64_t>> gaps;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (seconds_between(times[i - 1], times[i]) > bars.no_network) gaps.emplace_back(times[i - 1], times[i]);
  }
  return gaps;
}

void judge_words(const Timeline& timeline, const std::string& service, const Bars& bars, Verdict& verdict) {
  const Needs& need = needs().at(service);
  const auto gaps = without_network(timeline, bars);
  const auto silence_us = static_cast<std::int64_t>((bars.silence + bars.status_slack) * 1e6);
  for (const auto& [pid, words] : words_of_service(timeline, service)) {
    for (std::size_t i = 0; i < words.size(); ++i) {
      const auto& now = *words[i];
      // What was said so long ago, or longer.
      std::size_t before = i;
      while (before > 0 && now.t - words[before]->t < silence_us) --before;
      const auto& then = *words[before];
      if (now.t - then.t < silence_us) continue;
      const bool cut = std::any_of(gaps.begin(), gaps.end(),
                                   [&](const auto& gap) { return gap.first < now.t && gap.second > then.t; });
      if (cut) continue;
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

// The share of [from, to] in which a service's newest word was that it is ready; a word counts until the next.
double ready_share(const std::vector<const Heard<ServiceStatus>*>& words, std::int64_t from, std::int64_t to) {
  std::int64_t ready = 0;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (!is_ready(words[i]->message.state)) continue;
    const std::int64_t begin = std::max(from, words[i]->t);
    const std::int64_t end = std::min(to, i + 1 < words.size() ? words[i + 1]->t : to);
    ready += std::max<std::int64_t>(0, end - begin);
  }
  return static_cast<double>(ready) / static_cast<double>(std::max<std::int64_t>(1, to - from));
}

// Ready at the end, and not now and then only: one that is stale every other moment is not as it was before.
void judge_readiness(const Timeline& timeline, const Bars& bars, Verdict& verdict) {
  const std::int64_t gone = timeline.faults_gone();
  const std::int64_t end = std::min(timeline.ended_at, gone + static_cast<std::int64_t>(bars.recovery * 1e6));
  // A trial whose stack was well for a while ended then.
  const bool waited = seconds_between(gone, end) > bars.recovery - 1.0;
  const std::int64_t from = end - static_cast<std::int64_t>((waited ? bars.ready_age : bars.ready_age / 2.0) * 1e6);
  for (const std::string& service : ready_before(timeline)) {
    ++verdict.judged;
    std::vector<const Heard<ServiceStatus>*> words;
    for (const auto& heard : timeline.statuses) {
      const bool own = !heard.foreign && heard.message.name == service && timeline.is(service, heard.message.session);
      if (own && heard.t > gone && heard.t <= end) words.push_back(&heard);
    }
    const bool speaks = !words.empty() && seconds_between(words.back()->t, end) <= bars.ready_age;
    const double share = ready_share(words, std::max(from, gone), end);
    // A goal that comes a little late on a busy machine is told as stale now and then.
    if (speaks && share >= bars.ready_share) continue;
    note(verdict, end,
         words.empty()
             ? text("%s has said nothing in %.1f s since the fault was gone", service.c_str(),
                    seconds_between(gone, end))
             : text("%s says %s %.1f s after the fault was gone, and was ready in %.0f%% of the last %.0f s: %.200s",
                    service.c_str(), words.back()->message.state.c_str(), seconds_between(gone, words.back()->t),
                    100.0 * share, seconds_between(from, end), words.back()->message.reason.c_str()));
  }
}

// us, when all had said that they are ready which were before the faults.
std::int64_t ready_since(const Timeline& timeline) {
  std::set<std::string> missing = ready_before(timeline);
  std::int64_t since = 0;
  for (const auto& heard : timeline.statuses) {
    if (missing.empty()) break;
    if (heard.foreign || !is_ready(heard.message.state) || missing.erase(heard.message.name) == 0) continue;
    since = heard.t;
  }
  return since;
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
  judge_load(timeline, ready_since(timeline), bars, verdict);
  return verdict;
}

}  // namespace markservo::campaign
