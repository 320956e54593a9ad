#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace markservo::campaign {

// SplitMix64 (Steele, Lea, Flood 2014): the same numbers on every machine, unlike the standard's distributions.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15ULL);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
    return z ^ (z >> 31);
  }
  // [0, 1)
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }
  double between(double low, double high) { return low + (high - low) * uniform(); }
  // [0, size); `size` above 0.
  std::size_t below(std::size_t size) { return static_cast<std::size_t>(next() % size); }
  bool chance(double probability) { return uniform() < probability; }
  template <class T>
  const T& one_of(const std::vector<T>& choices) {
    return choices[below(choices.size())];
  }

 private:
  std::uint64_t state_;
};

}  // namespace markservo::campaign
