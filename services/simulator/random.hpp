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

// The streams that are taken. A new effect draws from a number that is not among them, and every seed gives all else
// what it gave before.
namespace streams {

// Of the world's seed.
inline constexpr std::uint64_t kLamps = 0x11;
inline constexpr std::uint64_t kLeftNoise = 0x22;  // of each frame
inline constexpr std::uint64_t kRightNoise = 0x23;
inline constexpr std::uint64_t kLostFrames = 0x33;
inline constexpr std::uint64_t kBase = 0x81;
inline constexpr std::uint64_t kTagFloor = 0x82;
inline constexpr std::uint64_t kTagReader = 0x83;
inline constexpr std::uint64_t kSonars = 0xA1;

// Of the seed that each of these parts has by its own stream.
inline constexpr std::uint64_t kWheelScale = 0x51;  // kBase's
inline constexpr std::uint64_t kLeftGrip = 0x52;
inline constexpr std::uint64_t kRightGrip = 0x53;
inline constexpr std::uint64_t kFirstCount = 0x54;
inline constexpr std::uint64_t kPivotWander = 0x55;
inline constexpr std::uint64_t kTagPlace = 0x61;  // kTagFloor's
inline constexpr std::uint64_t kTagRead = 0x71;   // kTagReader's
inline constexpr std::uint64_t kStrayRead = 0x72;
inline constexpr std::uint64_t kReadDelay = 0x73;
inline constexpr std::uint64_t kSonarScan = 0x91;  // kSonars'

}  // namespace streams

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
