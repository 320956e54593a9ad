#pragma once

#include <cstdint>
#include <optional>

namespace markservo::recorder {

struct ReadinessParameters {
  // main(), the one that writes, and liblcm's, which receives: the last begins when the group has been joined. Over TCP
  // liblcm has none.
  int threads = 3;
  // Over TCP nothing tells; it connects within milliseconds.
  std::int64_t tcp_us = 1'000'000;
  // Then it is taken for one that listens, in a way that nobody foresaw.
  std::int64_t patience_us = 10'000'000;
  // liblcm tests itself after joining, and says when that fails.
  std::int64_t self_test_us = 200'000;
};

// What can be seen of an lcm-logger that has just been started.
struct LoggerSight {
  bool alive = true;           // it, or what starts it
  std::optional<int> threads;  // its own, once it runs
  bool refused = false;        // it has said that liblcm's test of itself failed
};

// When an lcm-logger listens, which it does not tell: by its threads.
class LoggerReadiness {
 public:
  enum class State {
    kStarting,
    kTesting,  // it listens, and tests whether it hears
    kListens,
    kFailed,
  };

  LoggerReadiness(bool over_tcp, std::int64_t started_us, ReadinessParameters parameters = {})
      : parameters_(parameters), over_tcp_(over_tcp), started_us_(started_us) {}

  // `now_us`, of a clock that nobody sets, does not go back.
  State observe(const LoggerSight& sight, std::int64_t now_us);

 private:
  bool has_joined(const LoggerSight& sight, std::int64_t now_us) const;

  ReadinessParameters parameters_;
  bool over_tcp_;
  std::int64_t started_us_;
  std::optional<std::int64_t> joined_us_;
};

}  // namespace markservo::recorder
