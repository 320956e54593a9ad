#include "services/log-tool/play_node.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <stdexcept>
#include <thread>

#include "common/bus/bus_unavailable.hpp"
#include "common/bus/connection.hpp"
#include "common/bus/end_signals.hpp"
#include "common/bus/listener.hpp"
#include "common/reflection/value_text.hpp"
#include "common/time/clocks.hpp"
#include "services/log-tool/play_choice.hpp"
#include "services/log-tool/play_schedule.hpp"

namespace markservo::log_tool {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr std::int64_t kListen_us = 1'200'000;    // every state is repeated once a second or more often
constexpr std::int64_t kSilence_us = 10'000'000;  // worth a word
constexpr milliseconds kSlice{100};               // how long a signal may wait

void say(const std::string& line) {
  std::printf("%s\n", line.c_str());
  std::fflush(stdout);
}

std::string seconds_text(double seconds) {
  return fmt::format("{:.1f} s", seconds);
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

  void send(const Event& event) {
    const auto now = std::chrono::steady_clock::now();
    connection_.mend(now);
    if (connection_.publish(std::string(event.channel), event.data.data, event.data.size, now)) {
      ++sent_;
    } else if (failed_++ == 0) {
      first_failure_ = reflection::printable(std::string(event.channel)) + " of " + std::to_string(event.data.size) +
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
  if (const std::int64_t silence = due_us - steady_clock_us(); silence > kSilence_us) {
    say("the recording is silent: nothing is played for " + seconds_text(1e-6 * static_cast<double>(silence)));
  }
  for (std::int64_t left = due_us - steady_clock_us(); left > 0 && !bus::told_to_end();
       left = due_us - steady_clock_us()) {
    std::this_thread::sleep_for(std::min<microseconds>(microseconds(left), kSlice));
  }
  return !bus::told_to_end();
}

}  // namespace

bool play(const LogSet& logs, const PlayOptions& options) {
  PlayWishes wishes;
  if (!options.channels.empty()) wishes.channels = NameExpression(options.channels);
  wishes.all = options.all;
  wishes.join = options.join;
  Player player(options.url);
  wishes.written = channels_written(options.url);
  if (bus::told_to_end()) return true;
  const PlayPlan plan =
      plan_of(logs.events(), wishes, reflection::TypeCatalog::ours(), [] { return !bus::told_to_end(); });
  if (bus::told_to_end()) return true;
  if (logs.damaged())
    say("the log is damaged: what can be read is played (" + options.log_command + " verify says more)");
  for (const std::string& line : left_out_text(plan)) say(line);
  if (plan.events.empty()) {
    throw std::invalid_argument("no channel to play is in the log; " + options.log_command + " info shows what is");
  }
  if (!options.join) refuse_a_second_writer(plan, wishes, options.url);
  say("playing " + seconds_text(std::max(0.0, seconds_apart(plan.events.front().utime, plan.events.back().utime))) +
      " of " + std::to_string(plan.played.size()) + " channels to " + options.url);
  PlaySchedule schedule(options.speed);
  for (const Event& event : plan.events) {
    if (!wait_until(schedule.due_us(event.utime, steady_clock_us()))) break;
    player.send(event);
  }
  if (schedule.jumps() > 0)
    say("the log's time jumps " + std::to_string(schedule.jumps()) + " times: no waiting there");
  say("played " + std::to_string(player.sent()) + " messages");
  if (player.failed() == 0) return true;
  fmt::print(stderr, "{}: the bus did not take {} messages; the first on {}\n", options.own_name, player.failed(),
             player.first_failure());
  return false;
}

}  // namespace markservo::log_tool
