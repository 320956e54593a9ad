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
    {names::kTracked, "  following the marks, a whole image every 5 frames"},
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
    {"opencv_chain_tracked", "OpenCV chain / ours, following the marks", names::kOpencvChain, names::kTracked},
    {"opencv_chain_avx2", "OpenCV chain / ours, AVX2 and no more", names::kOpencvChain, names::kOursAvx2},
    {"opencv_chain_portable", "OpenCV chain / ours, no vectors", names::kOpencvChain, names::kOursPortable},
    {"stereobm_112_367", "StereoBM 112 to 367 / ours", names::kStereoBmNear, names::kOurs},
    {"stereobm_64", "StereoBM 0 to 63 / ours", names::kStereoBm64, names::kOurs},
    {"corners_and_flow", "corners and flow / ours", names::kCornersAndFlow, names::kOurs},
    {"apriltag", "AprilTag / ours", names::kAprilTag, names::kOurs},
    {"cold_read", "ours / cold read", names::kOurs, names::kColdRead},
    {"cold_read_tracked", "ours, following the marks / cold read", names::kTracked, names::kColdRead},
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

constexpr Row kAccuracyRows[] = {
    {"fronto_px", "square to the cameras, mean, px"},
    {"slant_px", "slanted by 0.12 px/px, mean, px"},
    {"rms_over_crlb", "rms / Cramer-Rao bound, the worse"},
    {"rms_over_pyrlk_slant", "slanted: rms / that of cv PyrLK 11"},
};
constexpr Row kCaseRows[] = {
    {"matches", "    matches"},
    {"p95_px", "    p95, px"},
    {"rms_px", "    rms, px"},
    {"converged_rms_px", "    the same iterated until it settles, rms, px"},
    {"crlb_px", "    Cramer-Rao bound of their windows, rms, px"},
    {"normalised_rms", "    rms of each over its own bound"},
    {"plane_rms_px", "    disparity of the mark's centre, rms, px"},
    {"plane_crlb_px", "    its bound by all pixels, rms, px"},
    {"pyrlk_px", "    cv PyrLK 11 from the true pixel, mean, px"},
    {"pyrlk_rms_px", "    the same, rms, px"},
};

nlohmann::ordered_json case_json(const MatchErrors& errors) {
  return {{"matches", errors.matches},
          {"marks", errors.marks},
          {"unlocated", errors.unlocated},
          {"p95_px", errors.p95},
          {"rms_px", errors.rms},
          {"converged_rms_px", errors.converged_rms},
          {"crlb_px", errors.crlb},
          {"normalised_rms", errors.normalised},
          {"plane_rms_px", errors.plane_rms},
          {"plane_crlb_px", errors.plane_crlb},
          {"pyrlk_matches", errors.flow_matches},
          {"pyrlk_px", errors.flow_mean},
          {"pyrlk_rms_px", errors.flow_rms}};
}

nlohmann::ordered_json accuracy_json(const Accuracy& accuracy) {
  return {{"fronto_px", accuracy.fronto.mean},         {"slant_px", accuracy.slanted.mean},
          {"rms_over_crlb", accuracy.rms_over_crlb()}, {"rms_over_pyrlk_slant", accuracy.rms_over_flow_slanted()},
          {"fronto", case_json(accuracy.fronto)},      {"slant", case_json(accuracy.slanted)}};
}

const char* name_of(std::int64_t vector_target) {
  return vector_target == 0 ? "none" : hwy::TargetName(vector_target);
}

}  // namespace

nlohmann::ordered_json report_json(const Times& times, const Agreement& agreement, const Accuracy& even_print,
                                   const Accuracy& soft_print, int num_rounds) {
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
  report["accuracy"] = accuracy_json(even_print);
  report["accuracy"]["soft_print"] = accuracy_json(soft_print);
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
  const auto accuracy_lines = [&](const char* print, const nlohmann::ordered_json& accuracy) {
    text << "error of the disparity of ours' matches, noise sigma 3, blur 0.6 px, " << print << "\n";
    for (const Row& row : kAccuracyRows) line(row.text, accuracy.at(row.key), 3);
    for (const char* which : {"fronto", "slant"}) {
      text << "  " << (std::string(which) == "fronto" ? "square to the cameras" : "slanted") << "\n";
      for (const Row& row : kCaseRows) line(row.text, accuracy.at(which).at(row.key), 3);
    }
  };
  accuracy_lines("prints like the simulator's", report.at("accuracy"));
  accuracy_lines("softer prints", report.at("accuracy").at("soft_print"));
  return text.str();
}

}  // namespace markservo::bench
