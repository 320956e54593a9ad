#include "services/stack-watch/stack_watch_node.hpp"

#include <cstdint>
#include <utility>
#include <vector>

#include "common/bus/end_signals.hpp"
#include "common/census/census_messages.hpp"
#include "common/logging/log.hpp"
#include "services/stack-watch/lcm_datagram.hpp"
#include "services/stack-watch/supervisor/process_device.hpp"

namespace markservo::stack_watch {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kTick{200};
constexpr std::int64_t kSecond_us = 1'000'000;

}  // namespace

StackWatchNode::StackWatchNode(StackWatchSettings settings)
    : settings_(std::move(settings)),
      socket_(group_address(settings_.url)),
      word_(settings_.robot),
      silence_(settings_.silence),
      recent_(now()),
      process_words_(settings_.robot) {
  bus::note_end_signals();
  reader_.emplace(settings_.supervisor, settings_.url,
                  [this](SupervisorAnswer answer) { note_answer(std::move(answer)); });
}

void StackWatchNode::run() {
  keep_bus();
  std::int64_t spoken_us = 0;
  std::int64_t stepped_us = 0;
  while (!bus::told_to_end()) {
    socket_.poll(kTick, [this](const Datagram& datagram) { on_datagram(datagram); });
    const std::int64_t steady_us = steady_clock_us();
    if (steady_us - stepped_us >= 1000 * kTick.count()) {
      stepped_us = steady_us;
      step();
    }
    if (steady_us - spoken_us < kSecond_us) continue;
    spoken_us = steady_us;
    keep_bus();
    speak();
  }
}

// Where there is no network it is tried again, and where own words do not come back the group is joined anew: the
// interface may have gone and come.
void StackWatchNode::keep_bus() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool gone = silence_.bus_is_gone();
  std::string problem = gone ? "own messages do not come back" : "";
  if (gone || !socket_.is_open()) {
    if (const std::string why = socket_.open(); !why.empty()) problem = "it cannot be joined: " + why;
  }
  if (!bus_.observe(problem, wall_clock_us())) return;
  if (bus_.is_gone()) {
    logging::warn("the bus is gone ({}): nobody is killed for silence", problem);
  } else {
    logging::info("the bus is back: silence is counted anew");
  }
}

void StackWatchNode::on_datagram(const Datagram& datagram) {
  const Instant when = now();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_crafted(datagram.data, datagram.size, datagram.size)) {
    if (crafted_.observe(datagram.from, when.wall_us)) {
      logging::warn("a crafted fragment came from {}: it ends what reads its channel", datagram.from);
    }
    return;
  }
  const auto message = read_datagram(datagram.data, datagram.size);
  if (!message) return;
  const census::Heard heard =
      census::heard_of(message->channel, message->payload, message->size, message->message_size, when.wall_us);
  recent_.observe(heard);
  if (heard.session) silence_.observe_session(*heard.session, when.steady_us);
  if (!message->whole) return;
  const auto word = census::word_in(message->channel, message->payload, message->size);
  if (!word) return;
  recent_.observe(*word, when);
  if (word->session == word_.session()) {
    silence_.observe_beacon(when.steady_us);
  } else if (word->host == word_.host()) {
    silence_.observe_word(word->name, word->pid, word->session, when.steady_us);
  }
}

void StackWatchNode::step() {
  std::vector<SilentService> silent;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Instant when = now();
    recent_.step(when);
    silent = silence_.step(supervisor_.running(), when.steady_us);
  }
  for (const SilentService& service : silent) kill_if_silent(service);
}

void StackWatchNode::kill_if_silent(const SilentService& silent) {
  if (!kill_if_supervised(silent, settings_.supervisor)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  kills_.add({silent.name, silent.pid, 1e-6 * static_cast<double>(silent.silent_us), silent.spoke, wall_clock_us()});
}

void StackWatchNode::note_answer(SupervisorAnswer answer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  switch (supervisor_.observe(std::move(answer), wall_clock_us())) {
    case SupervisorMemory::News::kNone:
      break;
    case SupervisorMemory::News::kCannotBeAsked:
      logging::error("the supervisor cannot be asked ({}): nobody is killed for silence", supervisor_.cannot_ask());
      break;
    case SupervisorMemory::News::kDied:
      logging::error("the supervisor is dead ({}); services still run: {}", supervisor_.why_not(),
                     orphans(supervisor_.processes()));
      break;
    case SupervisorMemory::News::kAnswers:
      logging::info("the supervisor answers");
      break;
  }
  if (!supervisor_.cannot_ask().empty()) return;
  census::KnownProcesses known{word_.host(), {}};
  for (const RunningProcess& process : supervisor_.running()) known.processes.insert({process.name, process.pid});
  recent_.observe(known);
  speak_of_processes(Telling::kChangedState);
}

// Why what is known of processes may not be so any more.
std::string StackWatchNode::trouble() const {
  if (!supervisor_.cannot_ask().empty()) return "its supervisor cannot be asked";
  return supervisor_.is_dead() ? "its supervisor is dead" : "";
}

std::string StackWatchNode::reason() const {
  if (!supervisor_.cannot_ask().empty()) return "the supervisor cannot be asked: " + supervisor_.cannot_ask();
  if (supervisor_.is_dead()) {
    return "the supervisor is dead; services still run: " + orphans(supervisor_.processes());
  }
  const std::int64_t wall_us = wall_clock_us();
  const std::string killed = kills_.told(wall_us);
  return killed.empty() ? crafted_.told(wall_us) : killed;
}

void StackWatchNode::speak() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool well = supervisor_.cannot_ask().empty() && !supervisor_.is_dead();
  silence_.send_beacon();
  socket_.send(word_.next(well, reason(), wall_clock_us()));
  speak_of_processes(Telling::kAll);
}

// The caller holds mutex_.
void StackWatchNode::speak_of_processes(Telling telling) {
  const Instant when = now();
  StackFindings found{supervisor_.processes(), trouble(), {}, kills_};
  for (const RunningProcess& process : supervisor_.running()) {
    found.heard[process.name] = {silence_.silent_for_us(process.name, process.pid, when.steady_us),
                                 silence_.limit_us()};
  }
  for (const auto& datagram : process_words_.next(found, telling, when.wall_us)) socket_.send(datagram);
}

}  // namespace markservo::stack_watch
