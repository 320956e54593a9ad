#include "services/recorder/logger/keep_logger_node.hpp"

#include <poll.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <optional>
#include <string_view>

#include "common/time/clocks.hpp"
#include "services/recorder/logger/logger_end.hpp"
#include "services/recorder/logger/logger_flush.hpp"
#include "services/recorder/logger/logger_names.hpp"
#include "services/recorder/logger/logger_words.hpp"
#include "services/recorder/proc_reader.hpp"
#include "services/recorder/process.hpp"
#include "services/recorder/signal_queue.hpp"

namespace markservo::recorder {
namespace {

constexpr std::int64_t kLook_us = 50'000;     // while its end is waited for
constexpr std::int64_t kIdle_us = 1'000'000;  // signals and words wake it

std::optional<int> whole_number(const std::string& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size() || number < 0) return std::nullopt;
  return number;
}

// Whole lines to a descriptor that others hold as well. What nobody takes just now is left out: lcm-logger must never
// wait for whoever reads its words.
void say(int descriptor, std::string_view text) {
  constexpr std::size_t kAtOnce = 4096;  // a pipe that can be written takes so much without waiting
  for (; !text.empty(); text.remove_prefix(std::min(text.size(), kAtOnce))) {
    pollfd waiting{descriptor, POLLOUT, 0};
    const bool taken = poll(&waiting, 1, 0) > 0 && (waiting.revents & POLLOUT) != 0;
    if (!taken || write(descriptor, text.data(), std::min(text.size(), kAtOnce)) < 0) return;
  }
}

class LoggerKeeper {
 public:
  LoggerKeeper(int words, std::vector<std::string> arguments) : words_(words) {
    std::signal(SIGPIPE, SIG_IGN);
    arguments.insert(arguments.begin(), kLcmLogger);
    ChildSetup setup;
    setup.out = setup.error = printed_.write_end();
    setup.ends_with_parent = true;
    setup.ignores_broken_pipes = true;  // should keep-logger be killed, it still has to write
    logger_ = start_process(kLcmLogger, arguments, setup);
    printed_.close_write_end();
  }

  // Until lcm-logger has ended.
  LoggerEnd run(SignalQueue* signals, bool told) {
    while (!has_ended()) {
      if ((told || signals->told()) && !flush_) flush_.emplace(steady_clock_us());
      if (flush_ && !ended_ && flush_->has_written(sight(), steady_clock_us())) {
        kill(logger_, SIGTERM);
        ended_ = true;
      }
      signals->wait(flush_ ? kLook_us : kIdle_us, flush_ ? -1 : printed_.read_end());
      pass_on();
    }
    pass_on();
    say(words_, filter_.rest());
    return end_;
  }

 private:
  LoggerThreads sight() const {
    const std::vector<pid_t> threads = threads_of(logger_);
    LoggerThreads sight{waits_in(logger_, logger_), std::nullopt};
    if (threads.size() > 1) sight.writer = waits_in(logger_, threads[1]);
    return sight;
  }

  bool has_ended() {
    int status = 0;
    if (waitpid(logger_, &status, WNOHANG) != logger_) return false;
    end_.by_signal = WIFSIGNALED(status);
    end_.number = end_.by_signal ? WTERMSIG(status) : WEXITSTATUS(status);
    return true;
  }

  void pass_on() {
    for (std::string text; !(text = printed_.take()).empty();) say(words_, filter_.lines_of(text));
  }

  int words_;
  Pipe printed_;
  pid_t logger_ = -1;
  WordFilter filter_;
  std::optional<LoggerFlush> flush_;
  bool ended_ = false;  // told to end, now
  LoggerEnd end_;
};

}  // namespace

int keep_logger(const std::vector<std::string>& words) {
  const auto recorder = words.size() > 2 ? whole_number(words[0]) : std::nullopt;
  const auto descriptor = words.size() > 2 ? whole_number(words[1]) : std::nullopt;
  if (!recorder || !descriptor) {
    std::fprintf(stderr, "usage: keep-logger RECORDER WORDS ARGUMENT...\n");
    return 2;
  }
  prctl(PR_SET_NAME, kKeepLogger);
  SignalQueue signals;
  LoggerKeeper keeper(*descriptor, {words.begin() + 2, words.end()});
  // The recorder's end is told by a signal, but not when it came before that was asked for.
  return keeper_exit_code(keeper.run(&signals, getppid() != *recorder));
}

}  // namespace markservo::recorder
