#include "tests/bench/read_once.hpp"

#include <array>
#include <cstddef>
#include <cstring>

namespace markservo::bench {
namespace {

std::uint64_t sum_of(const cv::Mat& image) {
  std::array<std::uint64_t, 8> sums{};  // independent, so that additions do not wait for each other
  const std::size_t num_bytes = image.total() * image.elemSize();
  for (std::size_t i = 0; i + sizeof sums <= num_bytes; i += sizeof sums) {
    std::array<std::uint64_t, 8> words;
    std::memcpy(words.data(), image.data + i, sizeof words);
    for (std::size_t k = 0; k < words.size(); ++k) sums[k] += words[k];
  }
  std::uint64_t total = 0;
  for (const std::uint64_t sum : sums) total += sum;
  return total;
}

}  // namespace

std::uint64_t read_once(const cv::Mat& left, const cv::Mat& right) {
  return sum_of(left) + sum_of(right);
}

}  // namespace markservo::bench
