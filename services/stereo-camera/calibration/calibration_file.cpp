#include "services/stereo-camera/calibration/calibration_file.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/calib3d.hpp>

#include "common/robot/configuration_error.hpp"
#include "common/text/text.hpp"
#include "services/stereo-camera/calibration/calibration_tree.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kRotationTolerance = 1e-3;  // of R R^T against 1: files written with few digits still pass
constexpr double kSingular = 1e-9;           // determinants below this are zero
constexpr int kMaxImageEdge_px = 16384;      // larger is a slip; robot.yaml has the same limit
constexpr std::size_t kMaxNumbers = 64;      // no entry that is asked for has more
constexpr const char* kMatrixForms =
    "an !!opencv-matrix with rows, cols, dt and rows x cols numbers, or a list of them";

std::string size_text(const cv::Mat& matrix) {
  return fmt::format("{} x {}", matrix.rows, matrix.cols);
}

std::optional<double> to_number(const YAML::Node& node) {
  if (!node.IsDefined() || !node.IsScalar()) return std::nullopt;  // of an absent node yaml-cpp's other questions throw
  if (node.Scalar() == ".Nan") return std::numeric_limits<double>::quiet_NaN();  // as OpenCV writes it
  double value = 0.0;
  if (!YAML::convert<double>::decode(node, value)) return std::nullopt;
  return value;
}

bool is_count(double value) {
  return value >= 0.0 && value == std::floor(value);
}

std::string value_text(const YAML::Node& node) {
  return node.IsScalar() ? "'" + text::printable(node.Scalar()) + "'" : "no single value";
}

}  // namespace

CalibrationFile::CalibrationFile(const std::string& path)
    : path_(path), root_(std::make_shared<const YAML::Node>(load_calibration_tree(path))) {}

void CalibrationFile::fail(const std::string& key, const std::string& value, const std::string& allowed) const {
  throw ConfigurationError(fmt::format("{}: key '{}' is {}; allowed: {}", path_, key, value, allowed));
}

void CalibrationFile::missing(const std::string& key, const std::string& allowed) const {
  throw ConfigurationError(fmt::format("{}: key '{}' is missing; allowed: {}", path_, key, allowed));
}

bool CalibrationFile::has(const Keys& keys) const {
  return std::any_of(keys.begin(), keys.end(), [&](const std::string& key) { return (*root_)[key].IsDefined(); });
}

const std::string& CalibrationFile::name(const Keys& keys) const {
  const auto found =
      std::find_if(keys.begin(), keys.end(), [&](const std::string& key) { return (*root_)[key].IsDefined(); });
  return found == keys.end() ? keys.front() : *found;
}

std::vector<double> CalibrationFile::numbers(const std::string& key, const YAML::Node& list) const {
  std::vector<double> values;
  for (const YAML::Node& item : list) {
    const std::optional<double> value = to_number(item);
    if (!value || values.size() == kMaxNumbers) fail(key, "not a readable matrix", kMatrixForms);
    values.push_back(*value);
  }
  return values;
}

cv::Mat CalibrationFile::any_matrix(const Keys& keys) const {
  const std::string& key = name(keys);
  const YAML::Node node = (*root_)[key];
  if (!node.IsDefined()) missing(key, "a matrix as cv::stereoCalibrate and cv::stereoRectify give it");
  std::vector<double> values;
  int rows = 1;
  if (node.IsMap()) {
    if (const YAML::Node data = node["data"]; data.IsDefined()) values = numbers(key, data);
    const double stated_rows = to_number(node["rows"]).value_or(0.0);
    const double stated_cols = to_number(node["cols"]).value_or(0.0);
    const bool counts = is_count(stated_rows) && is_count(stated_cols);
    if (!counts || stated_rows * stated_cols != static_cast<double>(values.size())) {
      fail(key, "not a readable matrix", kMatrixForms);
    }
    rows = static_cast<int>(stated_rows);
  } else if (node.IsSequence() && node.size() > 0 && node[0].IsSequence()) {
    for (const YAML::Node& row : node) {
      const std::vector<double> more = numbers(key, row);
      values.insert(values.end(), more.begin(), more.end());
      if (values.size() > kMaxNumbers || more.size() != node[0].size())
        fail(key, "not a readable matrix", kMatrixForms);
    }
    rows = static_cast<int>(node.size());
  } else if (node.IsSequence()) {
    values = numbers(key, node);
  } else {
    fail(key, "not a matrix", kMatrixForms);
  }
  if (values.empty()) return {};
  cv::Mat matrix = cv::Mat(values, true).reshape(1, rows);
  if (!cv::checkRange(matrix)) fail(key, "not finite", "finite numbers");
  return matrix;
}

cv::Mat CalibrationFile::matrix(const Keys& keys, int rows, int cols) const {
  const cv::Mat matrix = any_matrix(keys);
  const bool one_list = matrix.rows == 1 && matrix.cols == rows * cols;
  if (!one_list && (matrix.rows != rows || matrix.cols != cols)) {
    fail(name(keys), size_text(matrix), fmt::format("{} x {}", rows, cols));
  }
  return matrix.reshape(1, rows);
}

cv::Vec3d CalibrationFile::vector3(const Keys& keys) const {
  const cv::Mat matrix = any_matrix(keys);
  if (matrix.total() != 3) fail(name(keys), size_text(matrix), "three numbers in a row, a column or a list");
  const auto* values = matrix.ptr<double>();
  return {values[0], values[1], values[2]};
}

cv::Matx33d CalibrationFile::camera_matrix(const Keys& keys) const {
  const cv::Matx33d K = matrix(keys, 3, 3);
  const double determinant = cv::determinant(K);
  if (std::abs(determinant) < kSingular) {
    fail(name(keys), fmt::format("singular (determinant {:.6g})", determinant), "an invertible camera matrix");
  }
  if (K(0, 1) != 0.0) {
    fail(name(keys), fmt::format("of skewed pixels ({:.6g} px)", K(0, 1)),
         "[fx 0 cx; 0 fy cy; 0 0 1] (calibrate without skew: lens models here have none)");
  }
  if (!(K(0, 0) > 0.0) || !(K(1, 1) > 0.0) || K(1, 0) != 0.0 || K(2, 0) != 0.0 || K(2, 1) != 0.0 || K(2, 2) != 1.0) {
    fail(name(keys), "not a camera matrix", "[fx 0 cx; 0 fy cy; 0 0 1] in px with fx and fy above 0");
  }
  return K;
}

cv::Mat CalibrationFile::distortion(const Keys& keys, const std::vector<int>& counts) const {
  const cv::Mat coefficients = any_matrix(keys);
  const bool one_line = coefficients.rows <= 1 || coefficients.cols == 1;
  const int count = static_cast<int>(coefficients.total());
  if (!one_line || std::find(counts.begin(), counts.end(), count) == counts.end()) {
    std::string allowed;
    for (const int one : counts) allowed += (allowed.empty() ? "" : ", ") + std::to_string(one);
    fail(name(keys), size_text(coefficients), allowed + " coefficients in one row, column or list");
  }
  if (count == 0) return cv::Mat::zeros(1, 5, CV_64F);
  return coefficients.reshape(1, 1).clone();
}

cv::Matx33d CalibrationFile::rotation(const Keys& keys) const {
  const cv::Mat given = any_matrix(keys);
  cv::Matx33d R;
  if (given.total() == 3) {
    cv::Rodrigues(given.reshape(1, 3), R);
    return R;
  }
  R = matrix(keys, 3, 3);
  const double determinant = cv::determinant(R);
  if (std::abs(determinant) < kSingular) {
    fail(name(keys), fmt::format("singular (determinant {:.6g})", determinant), "a rotation matrix");
  }
  const double error = cv::norm(R * R.t() - cv::Matx33d::eye(), cv::NORM_INF);
  if (error > kRotationTolerance || determinant < 0.0) {
    fail(name(keys), fmt::format("not orthonormal (off by {:.6g}, determinant {:.6g})", error, determinant),
         "a rotation matrix");
  }
  return R;
}

cv::Matx34d CalibrationFile::projection(const Keys& keys) const {
  const cv::Matx34d P = matrix(keys, 3, 4);
  const double determinant = cv::determinant(P.get_minor<3, 3>(0, 0));
  if (std::abs(determinant) < kSingular) {
    fail(name(keys), fmt::format("singular (determinant {:.6g})", determinant), "an invertible left 3 x 3 part");
  }
  const bool zeros = P(0, 1) == 0.0 && P(1, 0) == 0.0 && P(2, 0) == 0.0 && P(2, 1) == 0.0;
  if (!zeros || !(P(0, 0) > 0.0) || !(P(1, 1) > 0.0) || P(2, 2) != 1.0) {
    fail(name(keys), "not a rectified projection", "[f 0 cx tx; 0 f cy 0; 0 0 1 0] in px with f above 0");
  }
  return P;
}

std::optional<double> CalibrationFile::number(const Keys& keys) const {
  if (!has(keys)) return std::nullopt;
  const YAML::Node node = (*root_)[name(keys)];
  const std::optional<double> value = to_number(node);
  if (!value) fail(name(keys), value_text(node), "a number");
  if (!std::isfinite(*value)) fail(name(keys), "not finite", "a finite number");
  return value;
}

std::optional<std::string> CalibrationFile::text(const Keys& keys) const {
  if (!has(keys)) return std::nullopt;
  const YAML::Node node = (*root_)[name(keys)];
  if (!node.IsScalar()) fail(name(keys), "no text", "a text");
  return node.Scalar();
}

std::optional<cv::Size> CalibrationFile::image_size() const {
  const Keys widths{"image_width", "imageWidth", "image_Width", "width"};
  const Keys heights{"image_height", "imageHeight", "image_Height", "height"};
  const Keys pairs{"image_size", "imageSize", "img_size", "size"};
  double width = 0.0;
  double height = 0.0;
  std::string key;
  if (has(widths) || has(heights)) {
    if (!has(widths)) missing(widths.front(), "image_width and image_height together, px");
    if (!has(heights)) missing(heights.front(), "image_width and image_height together, px");
    key = name(widths) + ", " + name(heights);
    width = *number(widths);
    height = *number(heights);
  } else if (has(pairs)) {
    key = name(pairs);
    const cv::Mat pair = any_matrix(pairs);
    if (pair.total() != 2) fail(key, "not a pair of numbers", "[width, height] in px");
    width = pair.ptr<double>()[0];
    height = pair.ptr<double>()[1];
  } else {
    return std::nullopt;
  }
  const auto valid = [](double edge) { return edge >= 1.0 && edge <= kMaxImageEdge_px && edge == std::floor(edge); };
  if (!valid(width) || !valid(height)) {
    fail(key, fmt::format("{:.6g} x {:.6g}", width, height), fmt::format("whole px from 1 to {}", kMaxImageEdge_px));
  }
  return cv::Size(static_cast<int>(width), static_cast<int>(height));
}

}  // namespace markservo::stereo_camera
