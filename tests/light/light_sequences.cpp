#include "tests/light/light_sequences.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <random>
#include <stdexcept>
#include <utility>

namespace markservo::light {
namespace {

constexpr int kSettled = 6;   // frames at the start with the marks' own light
constexpr int kPeriod = 12;   // frames between steps
constexpr int kLamp = 15;     // frames that a lamp is on, or off
constexpr int kVisible = 10;  // frames before the marks are hidden, of kRound
constexpr int kRound = 50;
constexpr int kDarkest = 3;  // frames into hiding at which the light changes

Gains scaled(const Gains& gains, double factor) {
  return {factor * gains[0], factor * gains[1], factor * gains[2]};
}

class Lights {
 public:
  explicit Lights(unsigned seed) : random_(seed) {}

  double draw(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
  double gain() { return std::exp(draw(std::log(kLeastGain), std::log(kGreatestGain))); }
  Gains cast() { return {1.0 + draw(-kCast, kCast), 1.0 + draw(-kCast, kCast), 1.0 + draw(-kCast, kCast)}; }
  Gains any() {
    const Gains gains = cast();
    return scaled(gains, gain());
  }
  Gains corner() {
    const auto side = [this] { return draw(0.0, 1.0) < 0.5 ? 1.0 - kCast : 1.0 + kCast; };
    const double blue = side();
    const double green = side();
    const double red = side();
    const double third = draw(0.0, 3.0);
    return scaled({blue, green, red}, third < 1.0 ? kLeastGain : third < 2.0 ? 1.0 : kGreatestGain);
  }

 private:
  std::mt19937 random_;
};

using Rule = std::function<LightFrame(int frame)>;  // frames from kSettled on, from 0

// A new light at every `period`-th frame.
Rule every(int period, std::function<Gains()> next) {
  return [period, next = std::move(next), now = Gains{}](int frame) mutable {
    if (frame % period == 0) now = next();
    return LightFrame{now, false};
  };
}

// One light and another in turn, `period` frames each, the first drawn anew each time.
Rule in_turn(int period, std::function<Gains()> first, const Gains& second) {
  return every(period, [first = std::move(first), second, is_first = false]() mutable {
    is_first = !is_first;
    return is_first ? first() : second;
  });
}

Rule make_rule(const std::string& kind, int num_frames, Lights& lights) {
  const Gains daylight{1.0, 1.0, 1.0};
  if (kind == "steps") return every(kPeriod, [&lights] { return lights.any(); });
  if (kind == "lamp") {
    return in_turn(
        kLamp,
        [] {
          return Gains{2.0 * (1.0 - kCast), 2.0, 2.0 * (1.0 + kCast)};
        },
        daylight);
  }
  if (kind == "saturation") {
    return in_turn(
        kPeriod, [&lights] { return scaled(lights.cast(), kGreatestGain); }, daylight);
  }
  if (kind == "corners") return every(kPeriod, [&lights] { return lights.corner(); });
  if (kind == "flicker")
    return in_turn(
        2, [&lights] { return lights.corner(); }, lights.corner());
  if (kind == "dusk") {
    Gains night = lights.corner();
    const double most = std::max({night[0], night[1], night[2]});
    night = scaled(night, kLeastGain * (1.0 + kCast) / most);
    return [night, num_frames](int frame) {
      const double share = 1.0 - std::abs(1.0 - 2.0 * frame / (num_frames - kSettled));
      LightFrame light;
      for (std::size_t c = 0; c < 3; ++c) light.gains[c] = std::pow(night[c], share);
      return light;
    };
  }
  if (kind == "hidden") {
    return [&lights, now = daylight](int frame) mutable {
      const int phase = frame % kRound;
      if (phase == kVisible + kDarkest) now = lights.any();
      return LightFrame{now, phase >= kVisible};
    };
  }
  throw std::invalid_argument("light_sequence: no kind '" + kind + "'");
}

}  // namespace

const std::vector<std::string>& light_kinds() {
  static const std::vector<std::string> kinds{"steps", "lamp", "dusk", "saturation", "corners", "flicker", "hidden"};
  return kinds;
}

std::vector<LightFrame> light_sequence(const std::string& kind, int num_frames, unsigned seed) {
  Lights lights(seed);
  Rule rule = make_rule(kind, num_frames, lights);
  std::vector<LightFrame> frames(static_cast<std::size_t>(num_frames));
  for (int i = kSettled; i < num_frames; ++i) frames[static_cast<std::size_t>(i)] = rule(i - kSettled);
  return frames;
}

}  // namespace markservo::light
