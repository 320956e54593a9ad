#pragma once

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <string>

namespace markservo::experiments {

// A bar with the time left on the standard error: redrawn in place on a terminal, one line per tenth elsewhere.
class ProgressBar {
 public:
  explicit ProgressBar(int total) : total_(total), begin_(std::chrono::steady_clock::now()) {}

  void advance(const std::string& note) {
    ++done_;
    const bool terminal = isatty(STDERR_FILENO) != 0;
    const int tenth = done_ * 10 / total_;
    if (!terminal && tenth == shown_tenth_ && done_ != total_) return;
    shown_tenth_ = tenth;
    const double elapsed = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
    const int left = static_cast<int>(std::lround(elapsed / done_ * (total_ - done_)));  // s
    const int filled = done_ * kWidth / total_;
    const std::string bar = std::string(static_cast<std::size_t>(filled), '#') +
                            std::string(static_cast<std::size_t>(kWidth - filled), '.');
    std::fprintf(stderr, "%s[%s] %d/%d  %d:%02d left  %-40.40s%s", terminal ? "\r" : "", bar.c_str(), done_, total_,
                 left / 60, left % 60, note.c_str(), terminal && done_ != total_ ? "" : "\n");
    std::fflush(stderr);
  }

 private:
  static constexpr int kWidth = 30;
  int total_;
  int done_ = 0;
  int shown_tenth_ = -1;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace markservo::experiments
