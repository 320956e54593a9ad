#pragma once

#include <string>
#include <string_view>

namespace markservo::recorder {

// Of what lcm-logger prints, the lines that are worth keeping: not the one a second that says all is well.
class WordFilter {
 public:
  // `text` as it comes, in pieces; the whole lines to keep, each with its end.
  std::string lines_of(std::string_view text);
  // What was said last without a line's end.
  std::string rest();

 private:
  std::string unfinished_;
};

// What the lcm-loggers of a recording have said, one after the other.
class LoggerWords {
 public:
  // The next one begins.
  void begin_run() { run_.clear(); }
  void add(std::string_view text);

  // The one that runs could not join the bus.
  bool says_self_test_failed() const;
  bool says_no_route() const;
  // The disk, of any of them.
  bool says_disk_was_slow() const;
  bool says_disk_is_full() const;
  // The first line of the one that runs; "nothing".
  std::string first_line() const;
  // All of it, without a line's end at the end; so many bytes at most.
  std::string all() const;

 private:
  static constexpr std::size_t kMostBytes =
      10'000;  // for the manifest: a disk that stays slow is told of again and again

  std::string run_;
  std::string all_;
};

}  // namespace markservo::recorder
