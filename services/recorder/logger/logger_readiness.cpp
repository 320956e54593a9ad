#include "services/recorder/logger/logger_readiness.hpp"

namespace markservo::recorder {

LoggerReadiness::State LoggerReadiness::observe(const LoggerSight& sight, std::int64_t now_us) {
  if (!sight.alive) return State::kFailed;
  if (!joined_us_) {
    if (!has_joined(sight, now_us)) return State::kStarting;
    joined_us_ = now_us;
  }
  if (now_us - *joined_us_ < parameters_.self_test_us) return State::kTesting;
  return sight.refused ? State::kFailed : State::kListens;
}

bool LoggerReadiness::has_joined(const LoggerSight& sight, std::int64_t now_us) const {
  const std::int64_t waited_us = now_us - started_us_;
  if (waited_us >= parameters_.patience_us) return true;
  if (!sight.threads) return false;
  return *sight.threads >= parameters_.threads || (over_tcp_ && waited_us >= parameters_.tcp_us);
}

}  // namespace markservo::recorder
