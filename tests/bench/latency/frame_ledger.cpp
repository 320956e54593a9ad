#include "tests/bench/latency/frame_ledger.hpp"

#include <cmath>
#include <stdexcept>

namespace markservo::bench {

FrameLedger::FrameLedger(std::size_t num_stages) : num_stages_(num_stages) {
  if (num_stages < 1) throw std::invalid_argument("FrameLedger: num_stages is 0; allowed: 1 or more");
}

void FrameLedger::sent(std::int64_t id, double time) {
  frames_[id] = {time, std::vector<double>(num_stages_, NAN)};
}

bool FrameLedger::came_in(std::size_t stage, std::int64_t id, double time) {
  const auto frame = frames_.find(id);
  if (frame == frames_.end()) return false;
  double& known = frame->second.came_in.at(stage);
  if (!std::isnan(known)) return false;
  known = time;
  return stage + 1 == num_stages_;
}

std::size_t FrameLedger::num_lost() const {
  return num_sent() - latencies().size();
}

std::vector<double> FrameLedger::latencies() const {
  std::vector<double> seconds;
  for (const auto& [id, frame] : frames_) {
    if (!std::isnan(frame.came_in.back())) seconds.push_back(frame.came_in.back() - frame.sent);
  }
  return seconds;
}

std::vector<double> FrameLedger::hops(std::size_t stage) const {
  std::vector<double> seconds;
  for (const auto& [id, frame] : frames_) {
    const double begin = stage == 0 ? frame.sent : frame.came_in.at(stage - 1);
    const double end = frame.came_in.at(stage);
    if (!std::isnan(begin) && !std::isnan(end)) seconds.push_back(end - begin);
  }
  return seconds;
}

}  // namespace markservo::bench
