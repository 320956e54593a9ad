#include "services/simulator/cameras/image_effects.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "services/simulator/random.hpp"

namespace markservo::simulator {
namespace {

// Normal deviates by table: entry i is the quantile of (i + 1/2) / kEntries. Twelve random bits a deviate, five from
// one word: some milliseconds for a frame pair, where a library's normal distribution takes a hundred.
constexpr int kIndexBits = 12;
constexpr int kEntries = 1 << kIndexBits;
constexpr int kDeviatesPerWord = 64 / kIndexBits;
constexpr int kFractionBits = 6;  // of a grey level, so that noise of part of a level is noise too

// Quantile of the standard normal distribution, by bisection on erfc: 4,096 times at start-up.
double normal_quantile(double probability) {
  double low = -10.0;
  double high = 10.0;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (0.5 * std::erfc(-middle / std::sqrt(2.0)) < probability ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

const std::array<double, kEntries>& unit_deviates() {
  static const std::array<double, kEntries> table = [] {
    std::array<double, kEntries> quantiles{};
    double sum_squares = 0.0;
    for (int i = 0; i < kEntries; ++i) {
      quantiles[static_cast<std::size_t>(i)] = normal_quantile((i + 0.5) / kEntries);
      sum_squares += quantiles[static_cast<std::size_t>(i)] * quantiles[static_cast<std::size_t>(i)];
    }
    for (double& value : quantiles) value /= std::sqrt(sum_squares / kEntries);
    return quantiles;
  }();
  return table;
}

using NoiseTable = std::array<std::int16_t, kEntries>;

NoiseTable noise_table(double sigma) {
  NoiseTable table{};
  const auto& unit = unit_deviates();
  for (std::size_t i = 0; i < table.size(); ++i) {
    table[i] = static_cast<std::int16_t>(std::lround(unit[i] * sigma * (1 << kFractionBits)));
  }
  return table;
}

std::uint8_t noisy(std::uint8_t level, std::int16_t noise) {
  constexpr int kHalf = 1 << (kFractionBits - 1);
  const int value = ((static_cast<int>(level) << kFractionBits) + noise + kHalf) >> kFractionBits;
  return static_cast<std::uint8_t>(std::clamp(value, 0, 255));
}

void add_noise(double sigma, std::uint64_t seed, cv::Mat& image) {
  const NoiseTable table = noise_table(sigma);
  RandomBits bits(seed);
  std::uint8_t* pixel = image.data;
  std::uint8_t* const end = pixel + image.total() * image.elemSize();
  while (pixel < end) {
    std::uint64_t word = bits.next();
    const auto count = std::min<std::ptrdiff_t>(kDeviatesPerWord, end - pixel);
    for (std::ptrdiff_t i = 0; i < count; ++i, ++pixel, word >>= kIndexBits) {
      *pixel = noisy(*pixel, table[word & (kEntries - 1)]);
    }
  }
}

void apply_gains(const ImageEffects& effects, cv::Mat& image) {
  const double gains[] = {effects.gain_blue, effects.gain_green, effects.gain_red};
  cv::Mat table(1, 256, CV_8UC3);
  for (int level = 0; level < 256; ++level) {
    auto& entry = table.at<cv::Vec3b>(0, level);
    for (int channel = 0; channel < 3; ++channel) {
      entry[channel] = static_cast<std::uint8_t>(std::lround(std::clamp(level * gains[channel], 0.0, 255.0)));
    }
  }
  cv::LUT(image, table, image);
}

}  // namespace

ImageEffects image_effects(const ImageSettings& image, const LightSettings& light) {
  ImageEffects effects;
  effects.blur_px = image.blur_px;
  effects.gain_red = light.gain * light.cast_red;
  effects.gain_green = light.gain * light.cast_green;
  effects.gain_blue = light.gain * light.cast_blue;
  effects.noise_sigma = image.noise_sigma;
  return effects;
}

void apply_effects(const ImageEffects& effects, std::uint64_t noise_seed, cv::Mat& image) {
  if (image.type() != CV_8UC3 || !image.isContinuous()) {
    throw std::invalid_argument("apply_effects: the image is not continuous 8-bit with three channels");
  }
  if (effects.blur_px > 0.0) cv::GaussianBlur(image, image, cv::Size(), effects.blur_px);
  if (effects.gain_red != 1.0 || effects.gain_green != 1.0 || effects.gain_blue != 1.0) apply_gains(effects, image);
  if (effects.noise_sigma > 0.0) add_noise(effects.noise_sigma, noise_seed, image);
}

NoiseSeeds noise_seeds(std::uint64_t seed, std::uint64_t frame_number) {
  return {seed_for(seed, streams::kLeftNoise, frame_number), seed_for(seed, streams::kRightNoise, frame_number)};
}

}  // namespace markservo::simulator
