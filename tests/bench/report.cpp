#include "tests/bench/report.hpp"

#include <hwy/targets.h>

#include <iomanip>
#include <sstream>

namespace markservo::bench {
namespace {

struct Row {
  const char* key;
  const char* text;
};

// A time's key is the contender's name.
constexpr Row kTimeRows[] = {
    {names::kOurs, "ours, whole image"},
    {names::kOursAvx2, "  with AVX2 and no more"},
    {names::kOursPortable, "  without vector instructions"},
    {names::kDetect, "  detection alone"},
    {names::kEqualise, "    histogram and equalisation table"},
    {names::kClassify, "    classification to masks"},
    {names::kLabel, "    clean-up and labelling (masks hot)"},
    {names::kLocate, "  location alone"},
    {names::kOpencvChain, "the chain of OpenCV's parts"},
    {names::kStereoBmNear, "cv::StereoBM, disparities 112 to 367"},
    {names::kStereoBm64, "cv::StereoBM, disparities 0 to 63"},
    {names::kCornersAndFlow, "cv::goodFeaturesToTrack 200 + PyrLK"},
    {names::kAprilTag, "AprilTag 36h11, decimate 2"},
    {names::kColdRead, "reading both images once, cold"},
    {names::kHotRead, "reading both images once, hot"},
};

struct RatioRow {
  const char* key;
  const char* text;
  const char* numerator;
  const char* denominator;
};
constexpr RatioRow kRatioRows[] = {
    {"opencv_chain", "OpenCV chain / ours", names::kOpencvChain, names::kOurs},
    {"opencv_chain_avx2", "OpenCV chain / ours, AVX2 and no more", names::kOpencvChain, names::kOursAvx2},
    {"opencv_chain_portable", "OpenCV chain / ours, no vectors", names::kOpencvChain, names::kOursPortable},
    {"stereobm_112_367", "StereoBM 112 to 367 / ours", names::kStereoBmNear, names::kOurs},
    {"stereobm_64", "StereoBM 0 to 63 / ours", names::kStereoBm64, names::kOurs},
    {"corners_and_flow", "corners and flow / ours", names::kCornersAndFlow, names::kOurs},
    {"apriltag", "AprilTag / ours", names::kAprilTag, names::kOurs},
    {"cold_read", "ours / cold read", names::kOurs, names::kColdRead},
};

constexpr Row kAgreementRows[] = {
    {"marks", "marks looked for"},
    {"missed_by_ours", "missed by ours"},
    {"missed_by_opencv_chain", "missed by the OpenCV chain"},
    {"mask_iou", "masks: intersection over union, median"},
    {"mask_iou_worst", "masks: intersection over union, worst"},
    {"box_px", "boxes: edges apart, p95, px"},
    {"disparity_px", "disparity: apart, p95, px"},
    {"ours_error_px", "disparity: ours off the truth, p95, px"},
    {"opencv_chain_error_px", "disparity: the chain's off the truth, p95, px"},
};

const char* name_of(std::int64_t vector_target) {
  return vector_target == 0 ? "none" : hwy::TargetName(vector_target);
}

}  // namespace

nlohmann::ordered_json report_json(const Times& times, const Agreement& agreement, int num_rounds) {
  nlohmann::ordered_json report;
  for (const RatioRow& row : kRatioRows) {
    if (times.count(row.numerator) == 0 || times.count(row.denominator) == 0) continue;
    report["ratio"][row.key] = median_ratio(times, row.numerator, row.denominator);
  }
  for (const Row& row : kTimeRows) {
    if (times.count(row.key) != 0) report["ms"][row.key] = median_time(times, row.key);
  }
  report["agreement"] = {{"marks", agreement.marks},
                         {"missed_by_ours", agreement.missed_by_ours},
                         {"missed_by_opencv_chain", agreement.missed_by_theirs},
                         {"mask_iou", agreement.mask_iou},
                         {"mask_iou_worst", agreement.mask_iou_worst},
                         {"box_px", agreement.box_px},
                         {"disparity_px", agreement.disparity_px},
                         {"ours_error_px", agreement.ours_error_px},
                         {"opencv_chain_error_px", agreement.theirs_error_px}};
  const VectorTargets targets = vector_targets();
  report["vector_targets"] = {
      {"best", name_of(targets.best)}, {"avx2", name_of(targets.avx2)}, {"portable", name_of(targets.portable)}};
  report["rounds"] = num_rounds;
  return report;
}

std::string report_text(const nlohmann::ordered_json& report) {
  std::ostringstream text;
  text << std::fixed;
  const auto line = [&](const char* what, const nlohmann::ordered_json& value, int decimals) {
    text << "  " << std::left << std::setw(48) << what << std::right << std::setw(9);
    if (value.is_number_integer()) {
      text << value.get<int>() << "\n";
    } else {
      text << std::setprecision(decimals) << value.get<double>() << "\n";
    }
  };
  const auto& targets = report.at("vector_targets");
  text << "processor time of one thread, ms per pair, median of " << report.at("rounds").get<int>() << " rounds\n";
  for (const Row& row : kTimeRows) {
    if (report.at("ms").contains(row.key)) line(row.text, report.at("ms").at(row.key), 3);
  }
  text << "ratios, median of those within a round (best vectors: " << targets.at("best").get<std::string>()
       << ", none: " << targets.at("portable").get<std::string>() << ")\n";
  for (const RatioRow& row : kRatioRows) {
    if (report.at("ratio").contains(row.key)) line(row.text, report.at("ratio").at(row.key), 2);
  }
  text << "answers\n";
  for (const Row& row : kAgreementRows) line(row.text, report.at("agreement").at(row.key), 3);
  return text.str();
}

}  // namespace markservo::bench
