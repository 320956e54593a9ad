#pragma once

// Seeded random bits that are the same on every machine and compiler, and quick enough for every pixel.

#include <cmath>
#include <cstdint>

namespace markservo::simulator {

// One step of splitmix64 (Steele, Lea, Flood 2014): scrambles a counter into 64 random bits.
inline std::uint64_t scramble(std::uint64_t x) {
  x += 0x9E3779B97F4A7C15ULL;
  x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9ULL;
  x = (x ^ (x >> 27)) * 0x94D049BB133111EBULL;
  return x ^ (x >> 31);
}

// A seed for one of several independent streams.
inline std::uint64_t seed_for(std::uint64_t seed, std::uint64_t stream, std::uint64_t number) {
  return scramble(scramble(scramble(seed) ^ stream) ^ number);
}

class RandomBits {
 public:
  explicit RandomBits(std::uint64_t seed) : state_(seed) {}

  std::uint64_t next() {
    const std::uint64_t bits = scramble(state_);
    state_ += 0x9E3779B97F4A7C15ULL;
    return bits;
  }

  // [0, 1)
  double uniform() { return static_cast<double>(next() >> 11) * 0x1.0p-53; }

  // [-1, 1)
  double symmetric() { return 2.0 * uniform() - 1.0; }

  // Mean 0, standard deviation 1 (Box and Muller 1958).
  double gaussian() {
    constexpr double kTwoPi = 6.283185307179586;
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(kTwoPi * uniform());
  }

 private:
  std::uint64_t state_;
};

}  // namespace markservo::simulator
