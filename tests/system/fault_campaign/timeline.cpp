#include "tests/system/fault_campaign/timeline.hpp"

#include <algorithm>
#include <limits>

#include "common/bus/safe_decode.hpp"
#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/message_leaves.hpp"

namespace markservo::campaign {
namespace {

template <class M>
void decode(const Event& event, Stream<M>& stream) {
  if (!event.whole()) return;
  auto decoded = bus::safe_decode<M>(event.data.data(), event.data.size());
  if (!decoded.ok) return;
  stream.push_back({event.t, 0.0, event.foreign, std::move(decoded.message)});
}

// When the trial began to take its stack down, us; far away where it did not say.
std::int64_t end_of(const History& history) {
  for (const auto& fact : history.facts) {
    if (fact.at("kind") == "end") return fact.at("t");
  }
  return std::numeric_limits<std::int64_t>::max();
}

Traffic traffic_of(const Event& event) {
  Traffic traffic{event.t, event.size, event.foreign, 0, 0};
  if (!event.whole()) return traffic;
  constexpr std::int64_t kFrame = 5;  // bytes around a text
  for (const LeafSpan& leaf : leaf_spans(reflection::TypeCatalog::ours(), event.data)) {
    if (leaf.kind != reflection::Kind::kString) continue;
    traffic.texts += static_cast<std::int64_t>(leaf.size);
    traffic.longest = std::max(traffic.longest, static_cast<std::int64_t>(leaf.size) - kFrame);
  }
  return traffic;
}

void decode_events(const History& history, std::int64_t end, Timeline& timeline) {
  for (const Event& event : history.events) {
    if (event.t > end) break;
    timeline.traffic[event.channel].push_back(traffic_of(event));
    const std::string& channel = event.channel;
    if (channel == "SIM_TRUTH") decode(event, timeline.truth);
    if (channel == "SIM_BASE_TRUTH") decode(event, timeline.base_truth);
    if (channel == "JOINT_COMMAND") decode(event, timeline.joint_commands);
    if (channel == "BASE_COMMAND") decode(event, timeline.base_commands);
    if (channel == "SERVO_GOAL") decode(event, timeline.servo_goals);
    if (channel == "BASE_GOAL") decode(event, timeline.base_goals);
    if (channel == "STOP") decode(event, timeline.stops);
    if (channel == "STOP_STATE") decode(event, timeline.stop_states);
    if (channel == "TASK_COMMAND") decode(event, timeline.task_commands);
    if (channel == "SERVO_STATUS") decode(event, timeline.servo_statuses);
    if (channel == "BASE_STATUS") decode(event, timeline.base_statuses);
    if (channel == "TASK_STATE") decode(event, timeline.task_states);
    if (channel == "SERVICE_STATUS") decode(event, timeline.statuses);
    timeline.ended_at = std::max(timeline.ended_at, event.t);
  }
}

Fault& fault_number(Timeline& timeline, const nlohmann::json& fact) {
  const auto index = fact.at("index").get<std::size_t>();
  if (timeline.faults.size() <= index) timeline.faults.resize(index + 1);
  return timeline.faults[index];
}

void take_fault(const nlohmann::json& fact, std::int64_t t, Timeline& timeline) {
  Fault& fault = fault_number(timeline, fact);
  const std::string what = fact.at("what");
  if (what == "planned") {
    fault.what = fact.at("describe");
    for (const auto& word : fact.at("words")) fault.words.insert(word.get<std::string>());
    for (const auto& name : fact.value("excuses", nlohmann::json::array()))
      fault.excuses.insert(name.get<std::string>());
  }
  if (what == "strike") fault.struck_at = t;
  if (what == "end") fault.ended_at = t;
}

void take_facts(const History& history, std::int64_t end, Timeline& timeline) {
  for (const auto& fact : history.facts) {
    const std::int64_t t = fact.at("t");
    const std::string kind = fact.at("kind");
    if (t > end && kind != "recording") continue;
    if (kind == "process") {
      const std::string state = fact.at("state");
      timeline.processes[fact.at("service")].push_back(
          {t, fact.at("pid"), state.empty() ? '?' : state[0], fact.at("rss_mb")});
    } else if (kind == "fault") {
      take_fault(fact, t, timeline);
    } else if (kind == "start") {
      timeline.task_starts.push_back(t);
      timeline.target = fact.at("target");
    } else if (kind == "recording") {
      timeline.recordings.push_back(fact);
    }
    if (t <= end) timeline.ended_at = std::max(timeline.ended_at, t);
  }
}

// A service's sessions are those under which its own processes, which the trial saw run, first spoke.
void learn_sessions(Timeline& timeline) {
  std::map<int, std::string> service_of;
  for (const auto& [service, samples] : timeline.processes) {
    for (const ProcessSample& sample : samples) service_of[sample.pid] = service;
  }
  std::set<int> known;
  for (const auto& status : timeline.statuses) {
    const auto found = service_of.find(status.message.pid);
    if (status.foreign || found == service_of.end() || found->second != status.message.name) continue;
    if (known.insert(status.message.pid).second) timeline.sessions[found->second].insert(status.message.session);
  }
}

template <class M>
void keep_own(const Timeline& timeline, Stream<M>& stream) {
  stream.erase(std::remove_if(stream.begin(), stream.end(),
                              [&](const Heard<M>& heard) {
                                return heard.foreign || !timeline.is("simulator", heard.message.session);
                              }),
               stream.end());
}

void run_clock(Timeline& timeline) {
  auto arm = timeline.truth.begin();
  for (const auto& base : timeline.base_truth) {
    for (; arm != timeline.truth.end() && arm->t < base.t; ++arm) timeline.clock.heard(arm->t, arm->message.utime);
    timeline.clock.heard(base.t, base.message.utime);
  }
  for (; arm != timeline.truth.end(); ++arm) timeline.clock.heard(arm->t, arm->message.utime);
}

template <class M>
void stamp(const WorldClock& clock, Stream<M>& stream) {
  for (auto& heard : stream) heard.world = clock.at(heard.t);
}

}  // namespace

std::int64_t Timeline::first_strike() const {
  std::int64_t first = ended_at;
  for (const Fault& fault : faults) {
    if (fault.struck_at > 0) first = std::min(first, fault.struck_at);
  }
  return first;
}

std::int64_t Timeline::faults_gone() const {
  std::int64_t last = 0;
  for (const Fault& fault : faults) {
    if (fault.struck_at > 0) last = std::max(last, fault.ended_at > 0 ? fault.ended_at : ended_at);
  }
  return last > 0 ? last : ended_at;
}

bool Timeline::loses_messages(std::int64_t t) const {
  constexpr std::int64_t kJust_us = 2'000'000;
  return std::any_of(faults.begin(), faults.end(), [&](const Fault& fault) {
    if (fault.words.count("network") == 0 || fault.struck_at == 0) return false;
    return t >= fault.struck_at && (fault.ended_at == 0 || t <= fault.ended_at + kJust_us);
  });
}

bool Timeline::flooded(std::int64_t t) const {
  constexpr std::int64_t kBefore_us = 1'000'000;
  constexpr std::int64_t kFlood = 500'000;  // bytes; a socket holds 4 MB, of which frames need most
  std::int64_t bytes = 0;
  for (const auto& [channel, events] : traffic) {
    auto one = std::lower_bound(events.begin(), events.end(), t - kBefore_us,
                                [](const Traffic& event, std::int64_t time) { return event.t < time; });
    for (; one != events.end() && one->t <= t + kBefore_us / 2; ++one) bytes += one->foreign ? one->size : 0;
  }
  return bytes > kFlood;
}

bool Timeline::is(const std::string& service, std::int64_t session) const {
  const auto found = sessions.find(service);
  return found != sessions.end() && found->second.count(session) > 0;
}

int Timeline::task_state_at(std::int64_t t) const {
  int state = -1;
  for (const auto& heard : task_states) {
    if (heard.t > t) break;
    if (!heard.foreign && is("task-manager", heard.message.session)) state = heard.message.state;
  }
  return state;
}

Timeline timeline_of(const History& history) {
  Timeline timeline;
  const std::int64_t end = end_of(history);
  decode_events(history, end, timeline);
  take_facts(history, end, timeline);
  learn_sessions(timeline);
  keep_own(timeline, timeline.truth);
  keep_own(timeline, timeline.base_truth);
  run_clock(timeline);
  const WorldClock& clock = timeline.clock;
  stamp(clock, timeline.truth);
  stamp(clock, timeline.base_truth);
  stamp(clock, timeline.joint_commands);
  stamp(clock, timeline.base_commands);
  stamp(clock, timeline.servo_goals);
  stamp(clock, timeline.base_goals);
  stamp(clock, timeline.stops);
  stamp(clock, timeline.stop_states);
  stamp(clock, timeline.servo_statuses);
  stamp(clock, timeline.base_statuses);
  stamp(clock, timeline.task_commands);
  stamp(clock, timeline.task_states);
  stamp(clock, timeline.statuses);
  timeline.printed = history.printed;
  return timeline;
}

}  // namespace markservo::campaign
