#include "services/camera-check/pair/corner_matches.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>

#include "services/camera-check/picture/picture_noise.hpp"

namespace markservo::camera_check {
namespace {

constexpr int kUsualWidth = 640;     // px; wider pictures are averaged down to at most this
constexpr int kHalfWindow = 7;       // px, of a window about a corner
constexpr int kHalfPeak = 3;         // px about the best place that belong to it
constexpr int kRefined = 2;          // px to either side of where the coarse picture found it
constexpr double kBackWithin = 1.5;  // px of the coarse picture

cv::Rect about(const cv::Point& centre, int half_width, int half_height) {
  return {centre.x - half_width, centre.y - half_height, 2 * half_width + 1, 2 * half_height + 1};
}

bool is_inside(const cv::Rect& part, const cv::Mat& image) {
  return (part & cv::Rect(0, 0, image.cols, image.rows)) == part;
}

// Where the window about `centre` of `from` is in `to`, within that reach of the same place. Nothing where no place is
// like it, or several are.
std::optional<cv::Point> find(const cv::Mat& from, const cv::Point& centre, const cv::Mat& to, const cv::Size& reach,
                              const MatchParameters& parameters) {
  const cv::Rect window = about(centre, kHalfWindow, kHalfWindow);
  if (!is_inside(window, from)) return std::nullopt;
  const cv::Rect searched =
      about(centre, reach.width + kHalfWindow, reach.height + kHalfWindow) & cv::Rect(0, 0, to.cols, to.rows);
  if (searched.width < window.width || searched.height < window.height) return std::nullopt;
  cv::Mat likeness;
  cv::matchTemplate(to(searched), from(window), likeness, cv::TM_CCOEFF_NORMED);
  double best = 0.0;
  cv::Point at;
  cv::minMaxLoc(likeness, nullptr, &best, nullptr, &at);
  if (!(best >= parameters.least_likeness)) return std::nullopt;
  cv::rectangle(likeness, about(at, kHalfPeak, kHalfPeak) & cv::Rect({0, 0}, likeness.size()), cv::Scalar(-1.0),
                cv::FILLED);
  double next = 0.0;
  cv::minMaxLoc(likeness, nullptr, &next);
  if (next > best - parameters.least_lead) return std::nullopt;
  return searched.tl() + at + cv::Point(kHalfWindow, kHalfWindow);
}

// The top of a parabola through three values, from the middle one: -0.5 to 0.5.
double top_of(double before, double middle, double after) {
  const double curvature = before - 2.0 * middle + after;
  return curvature < 0.0 ? std::clamp(0.5 * (before - after) / curvature, -0.5, 0.5) : 0.0;
}

// Where it is to a fraction of a pixel, near `guess`.
std::optional<cv::Point2d> refine(const cv::Mat& from, const cv::Point& centre, const cv::Mat& to,
                                  const cv::Point& guess, const MatchParameters& parameters) {
  const cv::Rect window = about(centre, kHalfWindow, kHalfWindow);
  const cv::Rect searched = about(guess, kRefined + 1 + kHalfWindow, kRefined + 1 + kHalfWindow);
  if (!is_inside(window, from) || !is_inside(searched, to)) return std::nullopt;
  cv::Mat likeness;
  cv::matchTemplate(to(searched), from(window), likeness, cv::TM_CCOEFF_NORMED);
  const cv::Rect inner(1, 1, likeness.cols - 2, likeness.rows - 2);
  double best = 0.0;
  cv::Point at;
  cv::minMaxLoc(likeness(inner), nullptr, &best, nullptr, &at);
  if (!(best >= parameters.least_likeness)) return std::nullopt;
  at += inner.tl();
  const auto value = [&](int u, int v) { return static_cast<double>(likeness.at<float>(at.y + v, at.x + u)); };
  const cv::Point whole = searched.tl() + at + cv::Point(kHalfWindow, kHalfWindow);
  return cv::Point2d(whole.x + top_of(value(-1, 0), value(0, 0), value(1, 0)),
                     whole.y + top_of(value(0, -1), value(0, 0), value(0, 1)));
}

cv::Mat smaller(const cv::Mat& picture, int factor) {
  cv::Mat small;
  cv::resize(picture, small, cv::Size(picture.cols / factor, picture.rows / factor), 0, 0, cv::INTER_AREA);
  return small;
}

// The variance within a window from which on two pictures of it with that noise are as like as a match has to be. Noise
// adds its own to what is to be seen and is another one in the other picture: likeness is at best 1 - noise^2 /
// variance.
double least_variance(double noise, const MatchParameters& parameters) {
  const double sigma = std::max(noise, parameters.least_noise);
  return sigma * sigma / (1.0 - parameters.least_likeness);
}

bool shows_something(const cv::Mat& image, const cv::Point& centre, double least_variance) {
  const cv::Rect window = about(centre, kHalfWindow, kHalfWindow) & cv::Rect({0, 0}, image.size());
  if (window.empty()) return false;
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(image(window), mean, deviation);
  return deviation[0] * deviation[0] >= least_variance;
}

// In pictures of a usual size.
PairMatches match_usual(const cv::Mat& left, const cv::Mat& right, const MatchParameters& parameters) {
  constexpr double kLeastQuality = 0.02;                            // of the best corner's
  constexpr double kLeastDistance = 8.0;                            // px
  if (std::min(left.cols, left.rows) < 4 * kHalfWindow) return {};  // the coarse picture holds no window
  std::vector<cv::Point2f> corners;
  cv::goodFeaturesToTrack(left, corners, parameters.max_corners, kLeastQuality, kLeastDistance);
  const cv::Mat coarse_left = smaller(left, 2);
  const cv::Mat coarse_right = smaller(right, 2);
  const cv::Size reach(static_cast<int>(parameters.columns_share * coarse_left.cols),
                       std::max(1, static_cast<int>(parameters.rows_share * coarse_left.rows)));
  PairMatches found;
  // The best corner's quality may be that of noise.
  const double least = least_variance(std::max(noise_of(coarse_left), noise_of(coarse_right)), parameters);
  for (const cv::Point2f& corner : corners) {
    const cv::Point at(cvRound(corner.x), cvRound(corner.y));
    const cv::Point coarse_at(at.x / 2, at.y / 2);
    if (!shows_something(coarse_left, coarse_at, least)) continue;
    ++found.num_corners;
    const auto there = find(coarse_left, coarse_at, coarse_right, reach, parameters);
    if (!there) continue;
    const auto back = find(coarse_right, *there, coarse_left, reach, parameters);
    if (!back || cv::norm(*back - coarse_at) > kBackWithin) continue;
    const auto fine = refine(left, at, right, at + 2 * (*there - coarse_at), parameters);
    if (fine) found.matches.push_back({cv::Point2d(at), *fine});
  }
  return found;
}

}  // namespace

PairMatches match_corners(const cv::Mat& left, const cv::Mat& right, const MatchParameters& parameters) {
  const int factor = (left.cols + kUsualWidth - 1) / kUsualWidth;
  if (factor <= 1) return match_usual(left, right, parameters);
  PairMatches found = match_usual(smaller(left, factor), smaller(right, factor), parameters);
  for (CornerMatch& match : found.matches) {
    match.left *= factor;
    match.right *= factor;
  }
  return found;
}

}  // namespace markservo::camera_check
