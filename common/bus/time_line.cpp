#include "common/bus/time_line.hpp"

#include <algorithm>
#include <cstdlib>

namespace markservo::bus {
namespace {

constexpr std::int64_t kNear_us = 1'000'000;
constexpr int kBelieved = 3;

}  // namespace

bool TimeLine::observe(std::int64_t utime) {
  if (!started_ || std::abs(utime - newest_) <= kNear_us) {
    newest_ = started_ ? std::max(newest_, utime) : utime;
    started_ = true;
    in_a_row_ = 0;
    return true;
  }
  const bool agrees = in_a_row_ > 0 && std::abs(utime - other_) <= kNear_us;
  other_ = agrees ? std::max(other_, utime) : utime;
  in_a_row_ = agrees ? in_a_row_ + 1 : 1;
  if (in_a_row_ < kBelieved) return false;
  newest_ = other_;
  in_a_row_ = 0;
  return true;
}

}  // namespace markservo::bus
