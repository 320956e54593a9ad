#include "services/mark-detector/learning/interval_fit.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "services/mark-detector/colour/hue.hpp"

namespace markservo::mark_detector {
namespace {

class Fitter {
 public:
  Fitter(const std::vector<LearningPixel>& pixels, double hue_deg, int chroma_min, const Limits& widest,
         const Limits& narrowest, const IntervalFitParameters& parameters)
      : widest_(widest), narrowest_(narrowest), parameters_(parameters), limits_(widest) {
    for (const LearningPixel& pixel : pixels) {
      all_of_mark_ += pixel.area * pixel.mark_share;
      if (pixel.chroma < chroma_min) continue;
      Sample sample;
      sample.mark = pixel.area * pixel.mark_share;
      sample.other = pixel.area - sample.mark;
      for (std::size_t k = 0; k < kNumLimits; ++k) sample.limited[k] = limited(pixel, k, hue_deg);
      samples_.push_back(sample);
    }
  }

  // Moves limits of [first, last) as long as that gains: of those that gain most or nearly so the one with most room.
  void improve(std::size_t first, std::size_t last) {
    for (std::size_t round = 0; round < 2 * kNumLimits; ++round) {
      std::array<Search, kNumLimits> searches;
      double best = 0.0;
      for (std::size_t k = first; k < last; ++k) {
        searches[k] = search(k);
        best = std::max(best, searches[k].overlap);
      }
      if (best < searches[first].overlap_now + parameters_.least_gain) return;
      std::size_t chosen = kNumLimits;
      for (std::size_t k = first; k < last; ++k) {
        if (searches[k].overlap < best - parameters_.least_gain) continue;
        if (chosen == kNumLimits || searches[k].room > searches[chosen].room) chosen = k;
      }
      limits_[chosen] = searches[chosen].best;
    }
  }

  // What later limits made needless is widened again, and the others are moved to the middle of where they serve.
  Limits settled() {
    for (std::size_t k = 0; k < kNumLimits; ++k) {
      if (limits_[k] != widest_[k]) limits_[k] = search(k).middle;
    }
    return limits_;
  }

 private:
  struct Sample {
    double mark = 0.0;   // px of the mark
    double other = 0.0;  // px of what is around it
    Limits limited{};
  };

  // What a limit can do, the others as they are.
  struct Search {
    double best = 0.0;         // its best place
    double overlap = 0.0;      // there
    double overlap_now = 0.0;  // where it is
    double middle = 0.0;       // of the places that serve as well but for the slack; widest if that does
    double room = 0.0;         // between these places' ends, share of the way from widest to narrowest
  };

  Search search(std::size_t k) const {
    const auto steps = static_cast<std::size_t>(parameters_.steps);
    const double width = (narrowest_[k] - widest_[k]) / parameters_.steps;
    std::vector<double> mark(steps + 1, 0.0);  // px that pass up to this step of the limit, and no further
    std::vector<double> other(steps + 1, 0.0);
    double mark_now = 0.0;
    double other_now = 0.0;
    for (const Sample& sample : samples_) {
      if (!passes_but_for(k, sample)) continue;
      const double place = width > 0.0 ? std::floor((sample.limited[k] - widest_[k]) / width) : parameters_.steps;
      const auto step = static_cast<std::size_t>(std::clamp(place, 0.0, double(parameters_.steps)));
      mark[step] += sample.mark;
      other[step] += sample.other;
      if (sample.limited[k] < limits_[k]) continue;
      mark_now += sample.mark;
      other_now += sample.other;
    }
    std::vector<double> overlaps(steps + 1);
    double marks = 0.0;
    double others = 0.0;
    for (std::size_t step = steps + 1; step-- > 0;) {
      marks += mark[step];
      others += other[step];
      overlaps[step] = overlap(marks, others);
    }
    Search result = judged(overlaps);
    result.overlap_now = overlap(mark_now, other_now);
    result.best = widest_[k] + width * result.best;
    result.middle = widest_[k] + width * result.middle;
    return result;
  }

  bool passes_but_for(std::size_t k, const Sample& sample) const {
    if (sample.limited[k] < widest_[k]) return false;
    for (std::size_t i = 0; i < kNumLimits; ++i) {
      if (i != k && sample.limited[i] < limits_[i]) return false;
    }
    return true;
  }

  // Places as steps.
  Search judged(const std::vector<double>& overlaps) const {
    const auto best = std::max_element(overlaps.begin(), overlaps.end());
    const double enough = *best - parameters_.slack;
    auto first = best;
    while (first != overlaps.begin() && *(first - 1) >= enough) --first;
    auto last = best;
    while (last + 1 != overlaps.end() && *(last + 1) >= enough) ++last;
    Search result;
    result.best = double(best - overlaps.begin());
    result.overlap = *best;
    result.room = double(last - first) / parameters_.steps;
    result.middle =
        first == overlaps.begin() ? 0.0 : 0.5 * double((first - overlaps.begin()) + (last - overlaps.begin()));
    return result;
  }

  double overlap(double mark, double other) const {
    return all_of_mark_ + other > 0.0 ? mark / (all_of_mark_ + other) : 0.0;
  }

  Limits widest_;
  Limits narrowest_;
  IntervalFitParameters parameters_;
  Limits limits_;
  std::vector<Sample> samples_;
  double all_of_mark_ = 0.0;  // px
};

}  // namespace

double limited(const LearningPixel& pixel, std::size_t limit, double hue_deg) {
  switch (limit) {
    case kHueLow:
      return signed_angle(pixel.hue_deg - hue_deg);
    case kHueHigh:
      return -signed_angle(pixel.hue_deg - hue_deg);
    case kSaturationLow:
      return pixel.saturation;
    case kSaturationHigh:
      return -pixel.saturation;
    case kValueLow:
      return pixel.value;
    default:
      return -pixel.value;
  }
}

Limits fit_interval(const std::vector<LearningPixel>& pixels, double hue_deg, int chroma_min, const Limits& widest,
                    const Limits& narrowest, const IntervalFitParameters& parameters) {
  Fitter fitter(pixels, hue_deg, chroma_min, widest, narrowest, parameters);
  fitter.improve(kHueLow, kValueLow);
  fitter.improve(kValueLow, kNumLimits);
  return fitter.settled();
}

}  // namespace markservo::mark_detector
