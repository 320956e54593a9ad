#include "services/mark-detector/learning/colour_learning.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "services/mark-detector/colour/hue.hpp"
#include "services/mark-detector/learning/percent.hpp"

namespace markservo::mark_detector {
namespace {

constexpr std::size_t kHueBins = 360;        // one a degree
constexpr double kLeastHalfWidth_deg = 1.0;  // so that the hue itself stays inside when limits are whole degrees

// What the mark's colour is read from: its pixels and how much each counts.
struct WeighedPixel {
  LearningPixel pixel;
  double weight = 0.0;
};
using WeighedPixels = std::vector<WeighedPixel>;

double weight_of(const WeighedPixels& pixels) {
  double sum = 0.0;
  for (const WeighedPixel& pixel : pixels) sum += pixel.weight;
  return sum;
}

// The boxes' pixels that have a hue.
WeighedPixels coloured(const std::vector<LearningPixel>& pixels, const LearningParameters& parameters,
                       bool with_clipped) {
  WeighedPixels result;
  for (const LearningPixel& pixel : pixels) {
    if (!pixel.in_box || pixel.chroma < std::max(1, parameters.chroma_min)) continue;
    if (pixel.level >= parameters.clipped && !with_clipped) continue;
    result.push_back({pixel, pixel.middle * pixel.mark_share});
  }
  return result;
}

// The hue about which most weight lies.
double peak_hue(const WeighedPixels& pixels) {
  std::array<double, kHueBins> histogram{};
  for (const auto& [pixel, weight] : pixels) histogram[static_cast<std::size_t>(pixel.hue_deg) % kHueBins] += weight;
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
double quantile(const WeighedPixels& pixels, double share, Value value) {
  std::vector<std::pair<double, double>> sorted;
  sorted.reserve(pixels.size());
  for (const auto& [pixel, weight] : pixels) sorted.emplace_back(value(pixel), weight);
  std::sort(sorted.begin(), sorted.end());
  double rest = share * weight_of(pixels);
  for (const auto& [number, weight] : sorted) {
    rest -= weight;
    if (rest < 0.0) return number;
  }
  return sorted.back().first;
}

double saturation(const LearningPixel& pixel) {
  return pixel.saturation;
}

// Without highlights and their rims: what is brighter than the body usually is, and paler by the light of its gloss.
WeighedPixels body_of(const WeighedPixels& pixels, double glossy_share) {
  const double usual = quantile(pixels, 0.5, saturation);
  // Luma, which a highlight raises even where the brightest channel is clipped.
  const double bright = quantile(pixels, 0.5, [](const LearningPixel& pixel) { return pixel.luma; });
  WeighedPixels body;
  for (const WeighedPixel& pixel : pixels) {
    const bool glossy = 1.0 - pixel.pixel.saturation / usual > glossy_share;
    if (!glossy || pixel.pixel.luma <= bright) body.push_back(pixel);
  }
  return body;
}

double hundredths(double number) {
  return std::floor(100.0 * number) / 100.0;
}

struct LimitRange {
  Limits widest{};
  Limits narrowest{};
};

LimitRange limits_about(const WeighedPixels& body, double hue_deg, const LearningParameters& parameters) {
  LimitRange range;
  for (std::size_t k = 0; k < kNumLimits; ++k) {
    const auto number = [&](const LearningPixel& pixel) { return limited(pixel, k, hue_deg); };
    range.widest[k] = quantile(body, parameters.trimmed, number);
    range.narrowest[k] = quantile(body, 1.0 - parameters.kept, number);
  }
  for (const Limit k : {kHueLow, kHueHigh}) {
    range.widest[k] = std::min(range.widest[k] - parameters.hue_margin_deg, -parameters.hue_half_width_deg);
    range.narrowest[k] = std::min(range.narrowest[k], -kLeastHalfWidth_deg);
  }
  range.widest[kSaturationLow] *= parameters.saturation_share;
  range.widest[kValueLow] *= parameters.value_share;
  range.widest[kSaturationHigh] = range.widest[kValueHigh] = -1.0;
  return range;
}

robot::ColourInterval interval_of(double hue_deg, const Limits& limits) {
  robot::ColourInterval interval;
  interval.hue_min_deg = wrapped(std::round(hue_deg + limits[kHueLow]));
  interval.hue_max_deg = wrapped(std::round(hue_deg - limits[kHueHigh]));
  interval.saturation_min = hundredths(limits[kSaturationLow]);
  interval.saturation_max = -std::floor(100.0 * limits[kSaturationHigh]) / 100.0;
  interval.value_min = hundredths(limits[kValueLow]);
  interval.value_max = -std::floor(100.0 * limits[kValueHigh]) / 100.0;
  return interval;
}

// Why the hue that dominates does not; empty if it does.
std::string doubt_of_hue(double coloured, double all, double cluster, const LearningParameters& parameters) {
  if (!(coloured >= parameters.coloured_share * all) || coloured <= 0.0) {
    return "only " + percent(all > 0.0 ? coloured / all : 0.0) +
           " of it has a hue (the rest is grey), allowed at least " + percent(parameters.coloured_share);
  }
  if (cluster < parameters.cluster_share * coloured) {
    return "no hue dominates: the most common one has " + percent(cluster / coloured) +
           " of its coloured pixels, allowed at least " + percent(parameters.cluster_share);
  }
  return {};
}

}  // namespace

LearnedColour learn_colour(const std::vector<LearningPicture>& pictures, const LearningParameters& parameters) {
  std::vector<LearningPixel> pixels = learning_pixels(pictures, parameters.equalise, parameters.pixels);
  set_mark_shares(pixels, parameters.shares);
  LearnedColour learned;
  learned.mark_px2.resize(pictures.size(), 0.0);
  double all = 0.0;
  for (const LearningPixel& pixel : pixels) {
    all += pixel.middle * pixel.mark_share;
    if (pixel.in_box) learned.mark_px2[pixel.picture] += pixel.area * pixel.mark_share;
  }
  WeighedPixels candidates = coloured(pixels, parameters, false);
  // A pure colour at full light is better than none.
  if (weight_of(candidates) < parameters.coloured_share * all) candidates = coloured(pixels, parameters, true);

  const double peak = peak_hue(candidates);
  const auto turn = [peak](const LearningPixel& pixel) { return signed_angle(pixel.hue_deg - peak); };
  WeighedPixels cluster;
  for (const WeighedPixel& pixel : candidates) {
    if (std::abs(turn(pixel.pixel)) <= parameters.cluster_deg) cluster.push_back(pixel);
  }
  learned.failure = doubt_of_hue(weight_of(candidates), all, weight_of(cluster), parameters);
  if (!learned.failure.empty()) return learned;

  const WeighedPixels body = body_of(cluster, parameters.glossy_share);
  const double hue_deg = peak + quantile(body, 0.5, turn);
  const double pale = quantile(body, parameters.trimmed, saturation);
  if (pale < parameters.least_saturation) {
    learned.failure = "its palest pixels have a saturation of " + percent(pale) + ", allowed at least " +
                      percent(parameters.least_saturation) + ": too pale to be told from what is grey";
    return learned;
  }
  const auto [widest, narrowest] = limits_about(body, hue_deg, parameters);
  const Limits limits = fit_interval(pixels, hue_deg, parameters.chroma_min, widest, narrowest, parameters.fit);
  learned.interval = interval_of(hue_deg, limits);
  if (limits[kValueLow] != widest[kValueLow] || limits[kValueHigh] != widest[kValueHigh]) {
    learned.doubt = "only brightness tells it from what is around it: in other light it will not be told apart";
  }
  return learned;
}

}  // namespace markservo::mark_detector
