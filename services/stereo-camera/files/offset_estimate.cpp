#include "services/stereo-camera/files/offset_estimate.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>

namespace markservo::stereo_camera {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double median_period(const std::vector<MotionStep>& steps) {
  std::vector<double> periods;
  for (const MotionStep& step : steps) periods.push_back(step.end_s - step.begin_s);
  const auto middle = periods.begin() + static_cast<std::ptrdiff_t>(periods.size() / 2);
  std::nth_element(periods.begin(), middle, periods.end());
  return *middle;
}

// The square root of the rate of change at equally spaced times; kNone where it is not known.
std::vector<double> sampled(const std::vector<MotionStep>& steps, double spacing_s, double longest_s) {
  const double begin_s = steps.front().begin_s;
  const auto count = static_cast<std::size_t>((steps.back().end_s - begin_s) / spacing_s);
  std::vector<double> samples(count, kNone);
  std::size_t step = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double time_s = begin_s + (static_cast<double>(i) + 0.5) * spacing_s;
    while (step + 1 < steps.size() && time_s > steps[step].end_s) ++step;
    const bool known = steps[step].end_s - steps[step].begin_s <= longest_s;
    if (known) samples[i] = std::sqrt(steps[step].rate);
  }
  return samples;
}

struct Similarity {
  double correlation = -1.0;
  std::size_t compared = 0;
};

// Of left[i] with right[i + lag].
Similarity similarity(const std::vector<double>& left, const std::vector<double>& right, std::ptrdiff_t lag) {
  const auto left_size = static_cast<std::ptrdiff_t>(left.size());
  const auto right_size = static_cast<std::ptrdiff_t>(right.size());
  double n = 0.0;
  double l = 0.0;
  double r = 0.0;
  double ll = 0.0;
  double rr = 0.0;
  double lr = 0.0;
  for (std::ptrdiff_t i = std::max<std::ptrdiff_t>(0, -lag); i < std::min(left_size, right_size - lag); ++i) {
    const double a = left[static_cast<std::size_t>(i)];
    const double b = right[static_cast<std::size_t>(i + lag)];
    if (std::isnan(a) || std::isnan(b)) continue;
    n += 1.0;
    l += a;
    r += b;
    ll += a * a;
    rr += b * b;
    lr += a * b;
  }
  const double spread = (n * ll - l * l) * (n * rr - r * r);
  if (!(spread > 0.0)) return {0.0, static_cast<std::size_t>(n)};
  return {(n * lr - l * r) / std::sqrt(spread), static_cast<std::size_t>(n)};
}

// Where the parabola through three equally spaced values has its top, in spacings from the middle one.
double parabola_top(double before, double middle, double after) {
  const double curvature = before - 2.0 * middle + after;
  return curvature < 0.0 ? std::clamp(0.5 * (before - after) / curvature, -1.0, 1.0) : 0.0;
}

// The samples on either side of the peak until the correlation has fallen to half of it.
struct Peak {
  std::size_t first = 0;
  std::size_t last = 0;
};
Peak peak_around(const std::vector<Similarity>& all, std::size_t best) {
  const double half = 0.5 * all[best].correlation;
  Peak peak{best, best};
  while (peak.first > 0 && all[peak.first].correlation > half) --peak.first;
  while (peak.last + 1 < all.size() && all[peak.last].correlation > half) ++peak.last;
  return peak;
}

// At all offsets from -farthest to farthest samples; with -1 where too few samples are compared.
std::vector<Similarity> search(const std::vector<double>& left, const std::vector<double>& right, std::ptrdiff_t shift,
                               std::ptrdiff_t farthest, std::size_t least) {
  std::vector<Similarity> all;
  for (std::ptrdiff_t lag = -farthest; lag <= farthest; ++lag) {
    Similarity one = similarity(left, right, lag + shift);
    if (one.compared < least) one.correlation = -1.0;
    all.push_back(one);
  }
  return all;
}

}  // namespace

OffsetEstimate estimate_offset(const std::vector<MotionStep>& left, const std::vector<MotionStep>& right,
                               const OffsetParameters& parameters) {
  OffsetEstimate estimate;
  if (left.empty() || right.empty()) return estimate;
  const double period_s = std::max(median_period(left), median_period(right));
  const double spacing_s = period_s / parameters.steps_per_period;
  const auto l = sampled(left, spacing_s, parameters.longest_step * period_s);
  const auto r = sampled(right, spacing_s, parameters.longest_step * period_s);
  const auto least = std::max(static_cast<std::size_t>(parameters.least_steps * parameters.steps_per_period),
                              std::min(l.size(), r.size()) / 2);
  const auto farthest = static_cast<std::ptrdiff_t>(parameters.max_offset_s / spacing_s);
  // Sample 0 of each is its own first moment.
  const double apart_s = right.front().begin_s - left.front().begin_s;
  const auto shift = -static_cast<std::ptrdiff_t>(std::llround(apart_s / spacing_s));
  const std::vector<Similarity> all = search(l, r, shift, farthest, least);
  const auto best = static_cast<std::size_t>(
      std::max_element(all.begin(), all.end(),
                       [](const Similarity& a, const Similarity& b) { return a.correlation < b.correlation; }) -
      all.begin());
  if (all[best].compared < least) return estimate;

  const Peak peak = peak_around(all, best);
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (i < peak.first || i > peak.last) estimate.rival = std::max(estimate.rival, all[i].correlation);
  }
  estimate.correlation = all[best].correlation;
  estimate.overlap_s = static_cast<double>(all[best].compared) * spacing_s;
  // Over half a period to either side, since motion is known by whole periods.
  const auto reach = static_cast<std::size_t>(parameters.steps_per_period / 2);
  double top = 0.0;
  if (best >= reach && best + reach < all.size()) {
    top = parabola_top(all[best - reach].correlation, all[best].correlation, all[best + reach].correlation);
  }
  const double lag =
      static_cast<double>(static_cast<std::ptrdiff_t>(best) - farthest + shift) + top * static_cast<double>(reach);
  estimate.offset_s = apart_s + lag * spacing_s;

  const double width = std::max(static_cast<double>(peak.last - peak.first), 1.0 * parameters.steps_per_period);
  const double independent = static_cast<double>(all[best].compared) / width;
  estimate.significance =
      independent > 3.0 ? std::atanh(std::min(estimate.correlation, 0.9999)) * std::sqrt(independent - 3.0) : 0.0;
  if (estimate.correlation < parameters.least_correlation || estimate.significance < parameters.least_significance) {
    estimate.status = OffsetStatus::kTooLittle;
  } else if (estimate.correlation - estimate.rival < parameters.least_lead) {
    estimate.status = OffsetStatus::kAmbiguous;
  } else {
    estimate.status = OffsetStatus::kFound;
  }
  return estimate;
}

}  // namespace markservo::stereo_camera
