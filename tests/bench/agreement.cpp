#include "tests/bench/agreement.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <sstream>

#include "tests/experiments/statistics.hpp"

namespace markservo::bench {
namespace {

using experiments::percentile;
using target_locator::Status;

struct Samples {
  std::vector<double> mask_iou;
  std::vector<double> box_px;
  std::vector<double> disparity_px;
  std::vector<double> ours_error_px;
  std::vector<double> theirs_error_px;
};

double mask_iou(const mark_detector::Region& ours, const BaselineAt::View& theirs) {
  cv::Mat filled(theirs.mask.size(), CV_8U, cv::Scalar(0));
  cv::drawContours(filled, theirs.contours, static_cast<int>(theirs.largest), cv::Scalar(1), cv::FILLED);
  int both = 0;
  int any = 0;
  for (int v = 0; v < filled.rows; ++v) {
    for (int u = 0; u < filled.cols; ++u) {
      const bool in_theirs = filled.at<uchar>(v, u) != 0;
      const bool in_ours = ours.test(u, v);
      both += in_theirs && in_ours ? 1 : 0;
      any += in_theirs || in_ours ? 1 : 0;
    }
  }
  return any > 0 ? static_cast<double>(both) / any : 0.0;
}

double box_difference(const mark_detector::Shape& ours, const cv::Rect& theirs) {
  return std::max({std::abs(ours.x - theirs.x), std::abs(ours.y - theirs.y),
                   std::abs(ours.x + ours.width - theirs.x - theirs.width),
                   std::abs(ours.y + ours.height - theirs.y - theirs.height)});
}

// What the baseline's disparities are off the truth, px; nothing for too few.
std::optional<double> baseline_error(const BaselineAt::Mark& mark, const scenes::Surface& truth,
                                     const geometry::StereoCamera& camera) {
  constexpr std::size_t kMinMatches = 6;  // as ours
  if (mark.matches.size() < kMinMatches) return std::nullopt;
  std::vector<double> errors;
  for (const BaselineAt::Match& match : mark.matches) {
    errors.push_back(match.u_left - match.u_right - truth.disparity(camera, match.u_left, match.v));
  }
  return experiments::median(errors);
}

double disparity_of(const Eigen::Vector3d& p_C, const geometry::StereoCamera& camera) {
  return camera.fx * camera.baseline / p_C.y();
}

}  // namespace

Agreement compare(const std::vector<scenes::StereoPair>& pairs, const geometry::StereoCamera& camera, Ours& ours,
                  BaselineAt& theirs) {
  Agreement result;
  Samples samples;
  for (const scenes::StereoPair& pair : pairs) {
    const Ours::Result our_result = ours.run(pair);
    const std::vector<BaselineAt::Mark>& their_marks = theirs.run(pair.left, pair.right);
    for (std::size_t i = 0; i < pair.marks.size(); ++i) {
      ++result.marks;
      const scenes::Surface& truth = pair.marks[i];
      const mark_detector::Finding& finding = our_result.detection.marks[i];
      const target_locator::Location& location = our_result.locations[i];
      const BaselineAt::Mark& mark = their_marks[i];
      const std::optional<double> their_error = baseline_error(mark, truth, camera);
      const bool located = location.status == Status::kLocated;
      result.missed_by_ours += located ? 0 : 1;
      result.missed_by_theirs += their_error ? 0 : 1;
      if (!located || !their_error) continue;
      const double our_error = disparity_of(location.p_C, camera) - disparity_of(truth.centre, camera);
      samples.ours_error_px.push_back(std::abs(our_error));
      samples.theirs_error_px.push_back(std::abs(*their_error));
      samples.disparity_px.push_back(std::abs(our_error - *their_error));
      for (const auto& [our_view, their_view] :
           {std::pair(&finding.left, &mark.left), std::pair(&finding.right, &mark.right)}) {
        samples.mask_iou.push_back(mask_iou(our_view->region, *their_view));
        samples.box_px.push_back(box_difference(our_view->shape, their_view->box));
      }
    }
  }
  constexpr double kMost = 0.95;
  result.mask_iou = experiments::median(samples.mask_iou);
  result.mask_iou_worst = percentile(samples.mask_iou, 0.0);
  result.box_px = percentile(samples.box_px, kMost);
  result.disparity_px = percentile(samples.disparity_px, kMost);
  result.ours_error_px = percentile(samples.ours_error_px, kMost);
  result.theirs_error_px = percentile(samples.theirs_error_px, kMost);
  return result;
}

std::vector<std::string> Agreement::complaints(const AgreementBounds& bounds) const {
  std::vector<std::string> lines;
  // Also broken by NaN, when there was nothing to compare.
  const auto require = [&](bool holds, const std::string& what, double value, const char* relation, double bound) {
    if (holds) return;
    std::ostringstream line;
    line << what << ": " << value << "; allowed: at " << relation << " " << bound;
    lines.push_back(line.str());
  };
  const auto at_most = [&](const std::string& what, double value, double bound) {
    require(value <= bound, what, value, "most", bound);
  };
  const auto at_least = [&](const std::string& what, double value, double bound) {
    require(value >= bound, what, value, "least", bound);
  };
  at_most("marks missed by ours", missed_by_ours, bounds.missed_share * marks);
  at_most("marks missed by the OpenCV chain", missed_by_theirs, bounds.missed_share * marks);
  at_least("masks' intersection over union, median", mask_iou, bounds.mask_iou);
  at_least("masks' intersection over union, worst", mask_iou_worst, bounds.mask_iou_worst);
  at_most("boxes' edges, ours against theirs, p95 (px)", box_px, bounds.box_px);
  at_most("disparity, ours against theirs, p95 (px)", disparity_px, bounds.disparity_px);
  at_most("disparity, ours against truth, p95 (px)", ours_error_px, bounds.ours_error_px);
  at_most("disparity, theirs against truth, p95 (px)", theirs_error_px, bounds.theirs_error_px);
  return lines;
}

}  // namespace markservo::bench
