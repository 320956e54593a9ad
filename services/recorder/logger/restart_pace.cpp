#include "services/recorder/logger/restart_pace.hpp"

namespace markservo::recorder {
namespace {

constexpr std::int64_t kLived_us = 10'000'000;  // one that lived longer begins anew
constexpr std::int64_t kFirstPause_us = 500'000;
constexpr std::int64_t kLongestPause_us = 2'000'000;  // what kills it passes unseen: so soon the recording is back

}  // namespace

std::int64_t RestartPace::pause_us(std::int64_t lived_us) {
  crashes_ = lived_us > kLived_us ? 0 : crashes_ + 1;
  if (crashes_ < 2) return 0;
  return crashes_ > 3 ? kLongestPause_us : kFirstPause_us << (crashes_ - 2);
}

}  // namespace markservo::recorder
