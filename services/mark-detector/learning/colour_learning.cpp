#include "services/mark-detector/learning/colour_learning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "services/mark-detector/colour/hue.hpp"
#include "services/mark-detector/colour/luma_equalisation.hpp"

namespace markservo::mark_detector {
namespace {

constexpr std::size_t kHueBins = 360;  // one a degree

struct Pixel {
  double hue_deg;
  double saturation;
  double value;  // equalised, of 1
  double weight;
};

struct Pixels {
  std::vector<Pixel> coloured;
  double weight = 0.0;  // of all pixels, also those without colour
};

// 1 in the middle, 0 at the ends.
double tent(int i, int size) {
  return 1.0 - std::abs((2.0 * i + 1.0) / size - 1.0);
}

// Coloured pixels; clipped ones only on demand.
Pixels gather(const std::vector<LearningPicture>& pictures, const LearningParameters& parameters, bool with_clipped) {
  Pixels pixels;
  for (const LearningPicture& picture : pictures) {
    LumaShift shift = no_shift();
    if (parameters.equalise) {
      LumaHistogram histogram{};
      accumulate(picture.image, histogram);
      shift = against_darkness(equalising_shift(histogram));
    }
    for (int j = 0; j < picture.height; ++j) {
      for (int i = 0; i < picture.width; ++i) {
        const std::uint8_t* p = picture.image.pixel(picture.x + i, picture.y + j);
        const double weight = tent(i, picture.width) * tent(j, picture.height);
        pixels.weight += weight;
        const Hsv hsv = hsv_of({double(p[0]), double(p[1]), double(p[2])});
        if (hsv.chroma < std::max(1, parameters.chroma_min)) continue;
        if (hsv.value >= parameters.clipped && !with_clipped) continue;
        const double brightening = shift[static_cast<std::size_t>(luma(p[0], p[1], p[2]))];
        pixels.coloured.push_back(
            {hsv.hue_deg, hsv.saturation, std::min(kWhiteLevel, hsv.value + brightening) / kWhiteLevel, weight});
      }
    }
  }
  return pixels;
}

double weight_of(const std::vector<Pixel>& pixels) {
  double sum = 0.0;
  for (const Pixel& pixel : pixels) sum += pixel.weight;
  return sum;
}

// The hue about which most weight lies.
double peak_hue(const std::vector<Pixel>& pixels) {
  std::array<double, kHueBins> histogram{};
  for (const Pixel& pixel : pixels) histogram[static_cast<std::size_t>(pixel.hue_deg) % kHueBins] += pixel.weight;
  constexpr int kReach = 8;  // bins to either side that count as one hue: noise of 3 levels on a dull mark
  double best = -1.0;
  double peak = 0.0;
  for (int bin = 0; bin < static_cast<int>(kHueBins); ++bin) {
    double sum = 0.0;
    for (int offset = -kReach; offset <= kReach; ++offset) {
      const auto k = static_cast<std::size_t>(bin + offset + static_cast<int>(kHueBins)) % kHueBins;
      sum += (kReach + 1 - std::abs(offset)) * histogram[k];
    }
    if (sum <= best) continue;
    best = sum;
    peak = bin + 0.5;
  }
  return peak;
}

// The value below which `share` of the pixels' weight lies.
template <class Value>
double quantile(const std::vector<Pixel>& pixels, double share, Value value) {
  std::vector<std::pair<double, double>> sorted;
  sorted.reserve(pixels.size());
  for (const Pixel& pixel : pixels) sorted.emplace_back(value(pixel), pixel.weight);
  std::sort(sorted.begin(), sorted.end());
  double rest = share * weight_of(pixels);
  for (const auto& [number, weight] : sorted) {
    rest -= weight;
    if (rest < 0.0) return number;
  }
  return sorted.back().first;
}

double hundredths(double number) {
  return std::floor(100.0 * number) / 100.0;
}

}  // namespace

LearnedColour learn_colour(const std::vector<LearningPicture>& pictures, const LearningParameters& parameters) {
  LearnedColour learned;
  Pixels pixels = gather(pictures, parameters, false);
  // A pure colour at full light is better than none.
  if (weight_of(pixels.coloured) < parameters.coloured_share * pixels.weight) {
    pixels = gather(pictures, parameters, true);
  }
  const auto percent = [](double share) { return std::to_string(std::lround(100.0 * share)) + "%"; };
  const double coloured = weight_of(pixels.coloured);
  if (!(coloured >= parameters.coloured_share * pixels.weight) || coloured <= 0.0) {
    learned.failure = "only " + percent(pixels.weight > 0.0 ? coloured / pixels.weight : 0.0) +
                      " of it has a hue (the rest is grey), allowed at least " + percent(parameters.coloured_share);
    return learned;
  }
  const double peak = peak_hue(pixels.coloured);
  const auto turn = [peak](const Pixel& pixel) { return signed_angle(pixel.hue_deg - peak); };
  std::vector<Pixel> cluster;
  for (const Pixel& pixel : pixels.coloured) {
    if (std::abs(turn(pixel)) <= parameters.cluster_deg) cluster.push_back(pixel);
  }
  const double share = weight_of(cluster) / coloured;
  if (share < parameters.cluster_share) {
    learned.failure = "no hue dominates: the most common one has " + percent(share) +
                      " of its coloured pixels, allowed at least " + percent(parameters.cluster_share);
    return learned;
  }
  const double median = quantile(cluster, 0.5, turn);
  const double low = std::min(quantile(cluster, parameters.trimmed, turn) - parameters.hue_margin_deg,
                              median - parameters.hue_half_width_deg);
  const double high = std::max(quantile(cluster, 1.0 - parameters.trimmed, turn) + parameters.hue_margin_deg,
                               median + parameters.hue_half_width_deg);
  const double pale = quantile(cluster, parameters.trimmed, [](const Pixel& pixel) { return pixel.saturation; });
  const double dark = quantile(cluster, parameters.trimmed, [](const Pixel& pixel) { return pixel.value; });
  if (pale < parameters.least_saturation) {
    learned.failure = "its palest pixels have a saturation of " + percent(pale) + ", allowed at least " +
                      percent(parameters.least_saturation) + ": too pale to be told from what is grey";
    return learned;
  }
  learned.interval.hue_min_deg = wrapped(std::floor(peak + low));
  learned.interval.hue_max_deg = wrapped(std::ceil(peak + high));
  learned.interval.saturation_min = hundredths(parameters.saturation_share * pale);
  learned.interval.saturation_max = 1.0;
  learned.interval.value_min = hundredths(parameters.value_share * dark);
  learned.interval.value_max = 1.0;
  return learned;
}

}  // namespace markservo::mark_detector
