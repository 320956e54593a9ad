#pragma once

// What happened on the bus and in the stack that a person should hear of, and for how long. No clock: the caller says
// when, us of the wall clock.

#include <cstdint>
#include <deque>
#include <optional>
#include <string>

namespace markservo::stack_watch {

inline constexpr std::int64_t kTold_us = 60'000'000;  // so long it is news

struct Kill {
  std::string name;
  int pid = 0;
  double silent_s = 0.0;
  bool spoke = false;
  std::int64_t utime = 0;  // wall clock, us
};

// Services that were killed for their silence.
class Kills {
 public:
  void add(const Kill& kill);
  const std::deque<Kill>& newest() const { return newest_; }  // oldest first
  // How long the process was silent, s; nothing: it was not killed, or long ago.
  std::optional<double> silent_s(const std::string& name, int pid) const;
  // Of the last one; empty a minute after it.
  std::string told(std::int64_t now_us) const;

 private:
  static constexpr std::size_t kKept = 20;

  std::deque<Kill> newest_;
};

// Datagrams that no LCM writes, made to end who reads them.
class CraftedFragments {
 public:
  // `from`: "ADDRESS:PORT". Whether none came in the last minute: those of a stream are no news.
  bool observe(const std::string& from, std::int64_t now_us);
  std::int64_t count() const { return count_; }
  // How many there were; empty a minute after the last one.
  std::string told(std::int64_t now_us) const;

 private:
  std::int64_t count_ = 0;
  std::int64_t newest_us_ = 0;
  std::string newest_from_;
};

}  // namespace markservo::stack_watch
