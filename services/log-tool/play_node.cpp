#include "services/log-tool/play_node.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <thread>
#include <utility>

#include "common/bus/bus_unavailable.hpp"
#include "common/bus/connection.hpp"
#include "common/bus/end_signals.hpp"
#include "common/bus/listener.hpp"
#include "common/reflection/value_text.hpp"
#include "common/time/clocks.hpp"
#include "services/log-tool/event_choice.hpp"
#include "services/log-tool/play_choice.hpp"
#include "services/log-tool/play_schedule.hpp"
#include "services/log-tool/time_steps.hpp"
#include "services/log-tool/time_walk.hpp"

namespace markservo::log_tool {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr std::int64_t kListen_us = 1'200'000;     // every state is repeated once a second or more often
constexpr milliseconds kSlice{100};                // how long a signal may wait
constexpr std::int64_t kPatience_us = 15'000'000;  // of a person who sees nothing happen

void say(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

std::set<std::string> channels_written(const std::string& url) {
  constexpr int kQueue = 1000;
  std::set<std::string> channels;
  bus::Listener listener(url, ".*", kQueue, [&](const bus::HeardBytes& message) { channels.insert(message.channel); });
  const std::int64_t end = steady_clock_us() + kListen_us;
  while (steady_clock_us() < end && !bus::told_to_end()) listener.poll(kSlice);
  return channels;
}

void refuse_a_second_writer(const PlayPlan& plan, const PlayWishes& wishes, const std::string& url) {
  std::string both;
  for (const std::string& channel : plan.played) {
    if (wishes.written.count(channel) > 0) both += " " + reflection::printable(channel);
  }
  if (both.empty()) return;
  throw BusInUse("somebody writes" + both + " on " + url +
                 " already; nothing was played (--join plays beside it what nobody writes and nothing "
                 "moves by)");
}

class Player {
 public:
  explicit Player(const std::string& url) : connection_(url, nullptr) {
    if (!connection_.open()) throw bus::BusUnavailable("bus " + url + ": cannot be joined: " + connection_.trouble());
  }

  void send(const logs::LogEvent& event) {
    const auto now = std::chrono::steady_clock::now();
    connection_.mend(now);
    const std::string channel(event.channel);
    if (connection_.publish({channel, event.data.data, event.data.size, event.utime}, now)) {
      ++sent_;
    } else if (failed_++ == 0) {
      first_failure_ = reflection::printable(channel) + " of " + std::to_string(event.data.size) +
                       " bytes: " + connection_.refused_sends(now).reason;
    }
  }

  std::int64_t sent() const { return sent_; }
  std::int64_t failed() const { return failed_; }
  const std::string& first_failure() const { return first_failure_; }

 private:
  bus::Connection connection_;
  std::int64_t sent_ = 0;
  std::int64_t failed_ = 0;
  std::string first_failure_;
};

// False when told to end meanwhile.
bool wait_until(std::int64_t due_us) {
  constexpr auto kWorthAWord_us = static_cast<std::int64_t>(1e6 * kSilence_s);
  const auto duration = [](std::int64_t us) { return duration_text(1e-6 * static_cast<double>(us)); };
  std::int64_t left = due_us - steady_clock_us();
  if (left > kWorthAWord_us) say("the recording is silent: nothing is played for " + duration(left));
  std::int64_t told_at = left;
  for (; left > 0 && !bus::told_to_end(); left = due_us - steady_clock_us()) {
    if (left > kWorthAWord_us && told_at - left >= kPatience_us) {
      say("still silent for " + duration(left));
      told_at = left;
    }
    std::this_thread::sleep_for(std::min<microseconds>(microseconds(left), kSlice));
  }
  return !bus::told_to_end();
}

PlayWishes wishes_of(const PlayOptions& options, const std::vector<logs::LogEvent>& events) {
  PlayWishes wishes;
  if (!options.channels.empty()) wishes.channels = ChannelPattern(options.channels, channels_of(events));
  wishes.all = options.all;
  wishes.join = options.join;
  wishes.by_udp = bus::is_udpm(options.url);
  return wishes;
}

// How the whole log's time goes, and what that means here.
void tell_order(const TimeSteps& steps) {
  if (steps.farthest_back > kDisorder_s) {
    say("the log's time goes " + disorder_text(steps) + ". Its order is kept" +
        (steps.jumps > 0 ? ", without waiting where the time jumps" : "") + "; --sort plays it by time");
  } else if (steps.jumps > 0) {
    say("the log's time jumps on by days " + std::to_string(steps.jumps) + (steps.jumps == 1 ? " time" : " times") +
        ": no waiting there");
  }
}

double longest_gap_of(const PlayOptions& options) {
  return options.longest_gap.value_or(std::numeric_limits<double>::infinity());
}

// What a person should know before it begins: how long it takes, and when nothing will happen.
void announce(const PlayPlan& plan, const PlayOptions& options) {
  TimeWalk walk(longest_gap_of(options));
  for (const logs::LogEvent& event : plan.events) walk.to(event.utime);
  const bool as_recorded = options.speed == 1.0;
  say("playing " + duration_text(walk.waited_s()) + " of " + std::to_string(plan.played.size()) + " channels to " +
      options.url + (as_recorded ? "" : ", in " + duration_text(walk.waited_s() / options.speed)));
  const std::string silences = silences_text(time_steps(plan.events));
  if (silences.empty()) return;
  say("the log has " + silences +
      (options.longest_gap ? ": shortened to " + duration_text(*options.longest_gap)
                           : "; --longest-gap S waits no longer than that"));
}

}  // namespace

bool play(const logs::LogSet& logs, const PlayOptions& options) {
  std::vector<logs::LogEvent> events = logs.events();
  if (options.sort) events = sorted_by_time(std::move(events));
  PlayWishes wishes = wishes_of(options, events);
  Player player(options.url);
  wishes.written = channels_written(options.url);
  if (bus::told_to_end()) return true;
  const PlayPlan plan = plan_of(events, wishes, reflection::TypeCatalog::ours(), [] { return !bus::told_to_end(); });
  if (bus::told_to_end()) return true;
  if (logs.damaged())
    say("the log is damaged: what can be read is played (" + options.log_command + " verify says more)");
  tell_order(time_steps(events));
  for (const std::string& line : left_out_text(plan)) say(line);
  if (const std::string others = others_played_text(plan); !others.empty()) say(others);
  if (plan.events.empty()) {
    throw std::invalid_argument("no channel to play is in the log; " + options.log_command + " info shows what is");
  }
  if (!options.join) refuse_a_second_writer(plan, wishes, options.url);
  announce(plan, options);
  PlaySchedule schedule(options.speed, longest_gap_of(options));
  for (const logs::LogEvent& event : plan.events) {
    if (!wait_until(schedule.due_us(event.utime, steady_clock_us()))) break;
    player.send(event);
  }
  say("played " + std::to_string(player.sent()) + " messages");
  if (player.failed() == 0) return true;
  fmt::print(stderr, "{}: the bus did not take {} messages; the first on {}\n", options.own_name, player.failed(),
             player.first_failure());
  return false;
}

}  // namespace markservo::log_tool
