#include "services/stack-watch/stack_watch_node.hpp"

// glibc 2.36 declares it for C only.
extern "C" {
#include <sys/pidfd.h>
}
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <markservo/ServiceStatus.hpp>
#include <markservo/channels.hpp>

#include "common/bus/end_signals.hpp"
#include "common/bus/host_name.hpp"
#include "common/bus/session.hpp"
#include "common/census/census_messages.hpp"
#include "common/logging/log.hpp"
#include "common/time/clocks.hpp"
#include "services/stack-watch/supervisor/command_line.hpp"
#include "services/stack-watch/supervisor/supervisor_reader.hpp"

namespace markservo::stack_watch {
namespace {

using std::chrono::milliseconds;

constexpr const char* kName = census::kStackWatch;
constexpr milliseconds kTick{200};
constexpr std::int64_t kSecond_us = 1'000'000;
constexpr std::int64_t kTold_us = 60 * kSecond_us;  // how long SERVICE_STATUS tells of what happened
constexpr std::size_t kKillsKept = 20;
constexpr std::size_t kMaxReason = 200;  // bytes, as any text on the bus

bool runs(const SupervisedProcess& process) {
  return process.pid > 0 && process.name != kName && (process.state == "RUNNING" || process.state == "STARTING");
}

}  // namespace

StackWatchNode::StackWatchNode(StackWatchSettings settings)
    : settings_(std::move(settings)),
      host_(bus::host_name()),
      session_(bus::random_session()),
      socket_(group_address(settings_.url)),
      silence_(settings_.silence),
      recent_(now()) {
  bus::note_end_signals();
  asking_ = std::thread([this] { ask_for_processes(); });
}

StackWatchNode::~StackWatchNode() {
  ended_ = true;
  asking_.join();
}

void StackWatchNode::run() {
  keep_bus();
  std::int64_t spoken_us = 0;
  std::int64_t ticked_us = 0;
  while (!bus::told_to_end()) {
    socket_.poll(kTick, [this](const Datagram& datagram) { hear(datagram); });
    const std::int64_t steady_us = steady_clock_us();
    if (steady_us - ticked_us >= 1000 * kTick.count()) {
      ticked_us = steady_us;
      tick();
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
  bus_problem_ = problem;
  if (problem.empty() == !bus_was_gone_) return;
  bus_was_gone_ = !problem.empty();
  bus_changed_us_ = wall_clock_us();
  if (bus_was_gone_) {
    logging::warn("the bus is gone ({}): nobody is killed for silence", problem);
  } else {
    logging::info("the bus is back: silence is counted anew");
  }
}

void StackWatchNode::hear(const Datagram& datagram) {
  const Instant when = now();
  const std::lock_guard<std::mutex> lock(mutex_);
  if (is_crafted(datagram.data, datagram.size, datagram.size)) {
    if (when.wall_us - crafted_us_ > kTold_us) {
      logging::warn("a crafted fragment came from {}: it ends what reads its channel", datagram.from);
    }
    ++crafted_;
    crafted_us_ = when.wall_us;
    crafted_from_ = datagram.from;
    return;
  }
  const auto message = read_datagram(datagram.data, datagram.size);
  if (!message) return;
  const census::Heard heard =
      census::heard_of(message->channel, message->payload, message->size, message->message_size, when.wall_us);
  recent_.hear(heard);
  if (heard.session) silence_.hear_session(*heard.session, when.steady_us);
  if (!message->whole) return;
  const auto word = census::word_in(message->channel, message->payload, message->size);
  if (!word) return;
  recent_.hear(*word, when);
  if (word->session == session_) {
    silence_.hear_beacon(when.steady_us);
  } else if (word->host == host_) {
    silence_.hear_word(word->name, word->pid, word->session, when.steady_us);
  }
}

void StackWatchNode::tick() {
  std::vector<SilentService> silent;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const Instant when = now();
    recent_.tick(when);
    silent = silence_.tick(supervised_.running, when.steady_us);
  }
  for (const SilentService& service : silent) kill_if_supervised(service);
}

// What it kills is held by a descriptor before the supervisor is asked whether it is still the one: its number cannot
// go to another process in between.
void StackWatchNode::kill_if_supervised(const SilentService& silent) {
  const int descriptor = pidfd_open(silent.pid, 0);
  if (descriptor < 0) {
    if (errno != ESRCH) logging::warn("{} is silent, but cannot be killed: {}", silent.name, std::strerror(errno));
    return;
  }
  try {
    const auto processes = ask_supervisor(settings_.supervisor);
    const bool same = std::any_of(processes.begin(), processes.end(), [&silent](const SupervisedProcess& process) {
      return runs(process) && process.name == silent.name && process.pid == silent.pid;
    });
    if (same && pidfd_send_signal(descriptor, SIGKILL, nullptr, 0) == 0) {
      const double silent_s = 1e-6 * static_cast<double>(silent.silent_us);
      logging::warn("{} (pid {}) said nothing on the bus for {:.1f} s{}: killed", silent.name, silent.pid, silent_s,
                    silent.spoke ? "" : " from its start on");
      const std::lock_guard<std::mutex> lock(mutex_);
      kills_.push_back({silent.name, silent.pid, silent_s, silent.spoke, wall_clock_us()});
      if (kills_.size() > kKillsKept) kills_.pop_front();
    }
  } catch (const std::runtime_error& error) {
    logging::warn("{} (pid {}) is silent, but is not killed: {}", silent.name, silent.pid, error.what());
  }
  close(descriptor);
}

void StackWatchNode::ask_for_processes() {
  while (!ended_) {
    Supervised answer;
    try {
      answer.processes = ask_supervisor(settings_.supervisor);
      answer.alive = true;
      for (const SupervisedProcess& process : answer.processes) {
        if (!runs(process)) continue;
        const bool speaks = must_speak(command_line_of(process.pid), process.name, settings_.url);
        answer.running.push_back({process.name, process.pid, speaks});
      }
    } catch (const SupervisorSilent& error) {
      answer.why_not = error.what();
    } catch (const CannotAsk& error) {
      answer.cannot_ask = error.what();
    }
    note_answer(std::move(answer));
    for (int i = 0; i < 10 && !ended_; ++i) std::this_thread::sleep_for(milliseconds(100));
  }
}

// A supervisor that is busy for a moment, or cannot be asked, makes nobody forget who runs: its last word counts until
// the next.
void StackWatchNode::note_answer(Supervised answer) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (answer.cannot_ask != supervised_.cannot_ask && !answer.cannot_ask.empty()) {
    logging::error("the supervisor cannot be asked ({}): nobody is killed for silence", answer.cannot_ask);
  }
  if (!answer.cannot_ask.empty()) {
    supervised_.cannot_ask = answer.cannot_ask;
    return;
  }
  const bool changed = answer.alive != supervised_.alive;
  answer.ever_alive = answer.alive || supervised_.ever_alive;
  answer.changed_us = changed ? wall_clock_us() : supervised_.changed_us;
  if (!answer.alive) {
    answer.processes = supervised_.processes;
    answer.running = supervised_.running;
  }
  supervised_ = std::move(answer);
  if (changed && !supervised_.alive) {
    logging::error("the supervisor is dead ({}); services still run: {}", supervised_.why_not, orphans());
  } else if (changed) {
    logging::info("the supervisor answers");
  }
  census::KnownProcesses known{host_, {}};
  for (const RunningProcess& process : supervised_.running) known.processes.insert({process.name, process.pid});
  recent_.know(known);
}

std::string StackWatchNode::orphans() const {
  std::string text;
  for (const SupervisedProcess& process : supervised_.processes) {
    if (!runs(process) || kill(process.pid, 0) != 0) continue;
    text += (text.empty() ? "" : ", ") + process.name + " (pid " + std::to_string(process.pid) + ")";
  }
  return text.empty() ? "none" : text;
}

std::string StackWatchNode::reason(bool* well) const {
  const std::int64_t wall_us = wall_clock_us();
  *well = supervised_.cannot_ask.empty() && (supervised_.alive || !supervised_.ever_alive);
  if (!supervised_.cannot_ask.empty()) return "the supervisor cannot be asked: " + supervised_.cannot_ask;
  if (!*well) return "the supervisor is dead; services still run: " + orphans();
  if (!kills_.empty() && wall_us - kills_.back().utime < kTold_us) {
    return kills_.back().name + " (pid " + std::to_string(kills_.back().pid) + ") said nothing for " +
           std::to_string(static_cast<int>(kills_.back().silent_s)) + " s and was killed";
  }
  if (crafted_ > 0 && wall_us - crafted_us_ < kTold_us) {
    return std::to_string(crafted_) + " crafted fragments came, the last from " + crafted_from_;
  }
  return {};
}

// Its own word tells others how the stack is, and, when it comes back, that there is a bus.
void StackWatchNode::speak() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ServiceStatus status{};
  bool well = true;
  status.reason = reason(&well);
  status.reason.resize(std::min(status.reason.size(), kMaxReason));
  status.utime = wall_clock_us();
  status.session = session_;
  status.seq = ++seq_;
  status.name = kName;
  status.host = host_;
  status.pid = getpid();
  status.version = MARKSERVO_VERSION;
  status.state = well ? "ready" : "stale";
  std::vector<std::uint8_t> payload(static_cast<std::size_t>(status.getEncodedSize()));
  status.encode(payload.data(), 0, static_cast<int>(payload.size()));
  silence_.send_beacon();
  const std::string channel =
      (settings_.robot.empty() ? "" : settings_.robot + "/") + std::string(channels::kServiceStatus.name);
  socket_.send(short_message(static_cast<std::uint32_t>(seq_), channel, payload));
}

}  // namespace markservo::stack_watch
