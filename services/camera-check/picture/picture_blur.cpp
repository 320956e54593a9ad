#include "services/camera-check/picture/picture_blur.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "services/camera-check/picture/picture_noise.hpp"

namespace markservo::camera_check {
namespace {

// Two smoothings, far enough apart that noise does not decide, near enough that edges do not meet.
struct Smoothings {
  double fine_px;
  double coarse_px;
};
constexpr Smoothings kOfSharp{1.0, 2.0};
constexpr Smoothings kOfBlurred{2.0, 4.0};  // a blurred edge hardly changes by the others
constexpr double kBlurred_px = 1.5;

// A difference of pixels two apart is a derivative averaged over 2 px, whose variance is 4 / 12.
constexpr double kDifference_px2 = 1.0 / 3.0;
constexpr double kNoSlope_px = 100.0;  // px; an edge that smoothing does not flatten

struct Slopes {
  cv::Mat along_u;  // grey levels per px
  cv::Mat along_v;
};

Slopes slopes_of(const cv::Mat& grey, double smoothing_px) {
  cv::Mat smooth;
  cv::GaussianBlur(grey, smooth, cv::Size(), smoothing_px, smoothing_px, cv::BORDER_REFLECT_101);
  const cv::Mat difference = (cv::Mat_<float>(1, 3) << -0.5F, 0.0F, 0.5F);
  Slopes slopes;
  cv::filter2D(smooth, slopes.along_u, CV_32F, difference);
  cv::filter2D(smooth, slopes.along_v, CV_32F, difference.t());
  return slopes;
}

double blur_from(const Smoothings& by, double fine_slope, double coarse_slope) {
  const double ratio2 = (fine_slope * fine_slope) / (coarse_slope * coarse_slope);
  if (!(ratio2 > 1.0)) return kNoSlope_px;
  const double fine2 = by.fine_px * by.fine_px + kDifference_px2;
  const double coarse2 = by.coarse_px * by.coarse_px + kDifference_px2;
  const double sigma2 = (coarse2 - ratio2 * fine2) / (ratio2 - 1.0);
  return std::min(kNoSlope_px, std::sqrt(std::max(0.0, sigma2)));
}

// The blur of each edge across which the picture changes along u, or, with all of them transposed, along v.
std::vector<double> edges_across(const Slopes& fine, const Slopes& coarse, const Smoothings& by, double least) {
  constexpr float kUpright = 2.0F;  // so many times steeper than along the other axis
  std::vector<double> blurs;
  for (int v = 0; v < fine.along_u.rows; ++v) {
    const auto* slope = fine.along_u.ptr<float>(v);
    const auto* other = fine.along_v.ptr<float>(v);
    for (int u = 1; u + 1 < fine.along_u.cols; ++u) {
      const float steep = std::abs(slope[u]);
      if (steep < least || steep < kUpright * std::abs(other[u])) continue;
      if (steep < std::abs(slope[u - 1]) || steep <= std::abs(slope[u + 1])) continue;
      blurs.push_back(blur_from(by, std::hypot(slope[u], other[u]),
                                std::hypot(coarse.along_u.at<float>(v, u), coarse.along_v.at<float>(v, u))));
    }
  }
  return blurs;
}

Slopes transposed(const Slopes& slopes) {
  return {slopes.along_v.t(), slopes.along_u.t()};
}

std::optional<double> sharpest(std::vector<double>& blurs, const BlurParameters& parameters) {
  if (blurs.size() < static_cast<std::size_t>(parameters.least_edges)) return std::nullopt;
  const auto at =
      blurs.begin() + static_cast<std::ptrdiff_t>(parameters.sharpest_share * static_cast<double>(blurs.size() - 1));
  std::nth_element(blurs.begin(), at, blurs.end());
  return *at;
}

// As two smoothings show it.
std::optional<double> blur_by(const Smoothings& by, const cv::Mat& levels, double noise,
                              const BlurParameters& parameters) {
  const Slopes fine = slopes_of(levels, by.fine_px);
  const Slopes coarse = slopes_of(levels, by.coarse_px);
  // White noise of sigma n has slopes of n / (sqrt(8 pi) s^2) after smoothing by s.
  const double of_noise = noise / (std::sqrt(8.0 * CV_PI) * by.fine_px * by.fine_px);
  const double least = std::max(parameters.least_gradient, parameters.noise_factor * of_noise);
  std::vector<double> across_u = edges_across(fine, coarse, by, least);
  std::vector<double> across_v = edges_across(transposed(fine), transposed(coarse), by, least);
  const auto along_u = sharpest(across_u, parameters);
  const auto along_v = sharpest(across_v, parameters);
  if (!along_u || !along_v) return along_u ? along_u : along_v;
  return std::max(*along_u, *along_v);
}

}  // namespace

std::optional<double> blur_of(const cv::Mat& grey, const BlurParameters& parameters) {
  cv::Mat levels;
  grey.convertTo(levels, CV_32F);
  const double noise = noise_of(levels);
  const std::optional<double> blur = blur_by(kOfSharp, levels, noise, parameters);
  if (!blur || *blur < kBlurred_px) return blur;
  const std::optional<double> again = blur_by(kOfBlurred, levels, noise, parameters);
  return again ? std::max(*blur, *again) : blur;
}

}  // namespace markservo::camera_check
