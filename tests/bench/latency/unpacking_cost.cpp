#include "tests/bench/latency/unpacking_cost.hpp"

#include <algorithm>
#include <chrono>
#include <opencv2/imgcodecs.hpp>

#include "tests/experiments/statistics.hpp"

namespace markservo::bench {
namespace {

constexpr std::size_t kFrames = 20;  // a time
constexpr double kMsPerS = 1e3;

}  // namespace

void UnpackingCost::measure(const std::vector<StereoFrame>& frames) {
  for (std::size_t i = 0; i < std::min(kFrames, frames.size()); ++i) {
    const auto begin = std::chrono::steady_clock::now();
    cv::imdecode(frames[i].left, cv::IMREAD_COLOR);
    cv::imdecode(frames[i].right, cv::IMREAD_COLOR);
    seconds_.push_back(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
}

double UnpackingCost::median_ms() const {
  return kMsPerS * experiments::percentile(seconds_, 0.50);
}

}  // namespace markservo::bench
