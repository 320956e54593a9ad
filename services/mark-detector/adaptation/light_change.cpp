#include "services/mark-detector/adaptation/light_change.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>

namespace markservo::mark_detector {
namespace {

constexpr int kBinsPerOctave = 64;  // 1.1% a bin; the median is interpolated within one
constexpr int kOctaves = 4;         // either way
constexpr int kZero = kBinsPerOctave * kOctaves;
constexpr std::size_t kLevels = 256;

using Ratios = std::array<int, 2 * kZero + 1>;  // how often each ratio occurs

using Logarithms = std::array<int, kLevels>;  // of each level, in bins

const Logarithms& logarithms() {
  static const Logarithms table = [] {
    Logarithms result{};
    for (std::size_t level = 1; level < kLevels; ++level) {
      result[level] = static_cast<int>(std::lround(kBinsPerOctave * std::log2(static_cast<double>(level))));
    }
    return result;
  }();
  return table;
}

// The ratio that half of `count` samples are below, as a place among the bins.
double median(const Ratios& ratios, int count) {
  const double half = 0.5 * count;
  double below = 0.0;
  std::size_t bin = 0;
  while (below + ratios[bin] < half) below += ratios[bin++];
  return static_cast<double>(bin) - 0.5 + (half - below) / ratios[bin];
}

// How many samples are within `reach` bins of a place.
int count_near(const Ratios& ratios, double place, double reach) {
  const int first = std::max(0, static_cast<int>(std::ceil(place - reach)));
  const int last = std::min(2 * kZero, static_cast<int>(std::floor(place + reach)));
  return std::accumulate(ratios.begin() + first, ratios.begin() + last + 1, 0);
}

// How often each ratio of levels, now over last, occurs in one channel.
struct ChannelRatios {
  Ratios ratios{};
  int count = 0;

  void add(int before, int after, const Logarithms& log, const LightChangeParameters& parameters) {
    if (std::min(before, after) < parameters.darkest || std::max(before, after) > parameters.brightest) return;
    const int ratio = kZero + log[static_cast<std::size_t>(after)] - log[static_cast<std::size_t>(before)];
    ++ratios[static_cast<std::size_t>(std::clamp(ratio, 0, 2 * kZero))];
    ++count;
  }
};

// Compares a grid of the image's pixels with the samples, which become this frame's.
std::array<ChannelRatios, 3> compare(const ImageView& image, const LightChangeParameters& parameters,
                                     LightSamples& samples) {
  const Logarithms& log = logarithms();
  std::array<ChannelRatios, 3> channels{};
  std::size_t sample = 0;
  const auto look_at = [&](const std::uint8_t* now) {
    // In the first frame what was before is made up; nothing is concluded from it.
    if (sample + 3 > samples.bgr.size()) samples.bgr.insert(samples.bgr.end(), now, now + 3);
    std::uint8_t* last = &samples.bgr[sample];
    sample += 3;
    for (std::size_t c = 0; c < 3; ++c) {
      channels[c].add(last[c], now[c], log, parameters);
      last[c] = now[c];
    }
  };
  const int row_step = std::max(1, image.height / parameters.rows);
  const int column_step = std::max(1, image.width / parameters.columns);
  for (int v = 0; v < image.height; v += row_step) {
    for (int u = column_step / 2; u < image.width; u += column_step) look_at(image.pixel(u, v));
  }
  return channels;
}

}  // namespace

LightChange light_change(const ImageView& image, const LightChangeParameters& parameters, LightSamples& samples) {
  const bool comparable = samples.width == image.width && samples.height == image.height;
  samples.width = image.width;
  samples.height = image.height;
  const std::array<ChannelRatios, 3> channels = compare(image, parameters, samples);
  LightChange change;
  change.certain = comparable;
  double product = 1.0;
  int told = 0;
  std::array<bool, 3> has_told{};
  for (std::size_t c = 0; c < 3; ++c) {
    const ChannelRatios& channel = channels[c];
    if (!comparable || channel.count < std::max(1, parameters.least_samples)) {
      change.certain = false;
      continue;
    }
    const double place = median(channel.ratios, channel.count);
    change.gains[c] = std::exp2((place - kZero) / kBinsPerOctave);
    product *= change.gains[c];
    ++told;
    has_told[c] = true;
    const int alike = count_near(channel.ratios, place, parameters.alike_octaves * kBinsPerOctave);
    change.certain = change.certain && alike >= parameters.alike_share * channel.count;
  }
  // A channel that cannot tell most likely changed as the others did; 1 would make a cast of their gain.
  for (std::size_t c = 0; c < 3 && told > 0; ++c) {
    if (!has_told[c]) change.gains[c] = std::pow(product, 1.0 / told);
  }
  return change;
}

}  // namespace markservo::mark_detector
