#include "services/stereo-camera/calibration/calibration_file.hpp"

#include <cmath>
#include <fstream>
#include <sstream>

#include "common/robot/configuration_error.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kRotationTolerance = 1e-3;  // of R R^T against 1: files written with few digits still pass
constexpr double kSingular = 1e-9;           // determinants below this are zero
constexpr int kMaxImageEdge_px = 16384;      // larger is a slip; robot.yaml has the same limit

std::string number_text(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

std::string size_text(const cv::Mat& matrix) {
  return matrix.empty() ? "not a matrix" : std::to_string(matrix.rows) + " x " + std::to_string(matrix.cols);
}

// cv::FileStorage tells formats by their first bytes and throws "Input file is invalid" otherwise.
void require_header(const std::string& path) {
  std::ifstream file(path);
  std::string first_line;
  if (!file || !std::getline(file, first_line)) {
    throw ConfigurationError(path + ": cannot be read or is empty; allowed: a calibration file of OpenCV");
  }
  const auto begins_with = [&](const char* start) { return first_line.rfind(start, 0) == 0; };
  if (!begins_with("%YAML") && !begins_with("<?xml") && !begins_with("{")) {
    throw ConfigurationError(path + ": line 1 is '" + first_line.substr(0, 40) +
                             "', the header is missing; allowed: '%YAML:1.0' as line 1 and '---' as line 2 (or '<?xml "
                             "version=\"1.0\"?>')");
  }
}

}  // namespace

CalibrationFile::CalibrationFile(const std::string& path) : path_(path) {
  require_header(path);
  try {
    storage_.open(path, cv::FileStorage::READ);
    if (!storage_.isOpened() || !storage_.root().isMap()) {
      throw ConfigurationError(path + ": has no keys; allowed: a calibration file of OpenCV");
    }
  } catch (const cv::Exception& error) {
    throw ConfigurationError(path + ": is not well-formed (" + error.err + "); allowed: a calibration file of OpenCV");
  }
}

void CalibrationFile::fail(const std::string& key, const std::string& value, const std::string& allowed) const {
  throw ConfigurationError(path_ + ": key '" + key + "' is " + value + "; allowed: " + allowed);
}

void CalibrationFile::missing(const std::string& key, const std::string& allowed) const {
  throw ConfigurationError(path_ + ": key '" + key + "' is missing; allowed: " + allowed);
}

bool CalibrationFile::has(const std::string& key) const {
  return !storage_[key].empty();
}

std::string CalibrationFile::first_of(const std::vector<std::string>& keys) const {
  for (const std::string& key : keys) {
    if (has(key)) return key;
  }
  return keys.front();
}

cv::Mat CalibrationFile::any_matrix(const std::string& key) const {
  if (!has(key)) missing(key, "a matrix as cv::stereoCalibrate and cv::stereoRectify give it");
  cv::Mat matrix;
  try {
    cv::Mat stored;
    storage_[key] >> stored;
    if (stored.channels() != 1 || stored.dims > 2) fail(key, "not a matrix of numbers", "an !!opencv-matrix");
    stored.convertTo(matrix, CV_64F);
  } catch (const ConfigurationError&) {
    throw;
  } catch (const std::exception&) {
    fail(key, "not a readable matrix", "an !!opencv-matrix with rows, cols, dt and rows x cols numbers");
  }
  if (matrix.empty()) fail(key, "not a matrix", "an !!opencv-matrix with rows, cols, dt and data");
  if (!cv::checkRange(matrix)) fail(key, "not finite", "finite numbers");
  return matrix;
}

cv::Mat CalibrationFile::matrix(const std::string& key, int rows, int cols) const {
  cv::Mat matrix = any_matrix(key);
  if (matrix.rows != rows || matrix.cols != cols) {
    fail(key, size_text(matrix), std::to_string(rows) + " x " + std::to_string(cols));
  }
  return matrix;
}

cv::Matx33d CalibrationFile::camera_matrix(const std::string& key) const {
  const cv::Matx33d K = matrix(key, 3, 3);
  const double determinant = cv::determinant(K);
  if (std::abs(determinant) < kSingular) {
    fail(key, "singular (determinant " + number_text(determinant) + ")", "an invertible camera matrix");
  }
  if (!(K(0, 0) > 0.0) || !(K(1, 1) > 0.0) || K(1, 0) != 0.0 || K(2, 0) != 0.0 || K(2, 1) != 0.0 || K(2, 2) != 1.0) {
    fail(key, "not a camera matrix", "[fx 0 cx; 0 fy cy; 0 0 1] in px with fx and fy above 0");
  }
  return K;
}

cv::Mat CalibrationFile::distortion(const std::string& key) const {
  const cv::Mat coefficients = any_matrix(key);
  const int count = static_cast<int>(coefficients.total());
  const bool one_line = coefficients.rows == 1 || coefficients.cols == 1;
  if (!one_line || (count != 4 && count != 5 && count != 8 && count != 12 && count != 14)) {
    fail(key, size_text(coefficients), "4, 5, 8, 12 or 14 coefficients in one row or column");
  }
  return coefficients.reshape(1, 1).clone();
}

cv::Matx33d CalibrationFile::rotation(const std::string& key) const {
  const cv::Matx33d R = matrix(key, 3, 3);
  const double determinant = cv::determinant(R);
  if (std::abs(determinant) < kSingular) {
    fail(key, "singular (determinant " + number_text(determinant) + ")", "a rotation matrix");
  }
  const double error = cv::norm(R * R.t() - cv::Matx33d::eye(), cv::NORM_INF);
  if (error > kRotationTolerance || determinant < 0.0) {
    fail(key, "not orthonormal (off by " + number_text(error) + ", determinant " + number_text(determinant) + ")",
         "a rotation matrix");
  }
  return R;
}

cv::Matx34d CalibrationFile::projection(const std::string& key) const {
  const cv::Matx34d P = matrix(key, 3, 4);
  const double determinant = cv::determinant(P.get_minor<3, 3>(0, 0));
  if (std::abs(determinant) < kSingular) {
    fail(key, "singular (determinant " + number_text(determinant) + ")", "an invertible left 3 x 3 part");
  }
  const bool zeros = P(0, 1) == 0.0 && P(1, 0) == 0.0 && P(2, 0) == 0.0 && P(2, 1) == 0.0;
  if (!zeros || !(P(0, 0) > 0.0) || !(P(1, 1) > 0.0) || P(2, 2) != 1.0) {
    fail(key, "not a rectified projection", "[f 0 cx tx; 0 f cy 0; 0 0 1 0] in px with f above 0");
  }
  return P;
}

std::optional<double> CalibrationFile::number(const std::string& key) const {
  const cv::FileNode node = storage_[key];
  if (node.empty()) return std::nullopt;
  if (!node.isReal() && !node.isInt()) fail(key, "not a number", "a number");
  const double value = node.real();
  if (!std::isfinite(value)) fail(key, "not finite", "a finite number");
  return value;
}

std::optional<cv::Size> CalibrationFile::image_size() const {
  double width = 0.0;
  double height = 0.0;
  std::string key = "image_size";
  if (has("image_width") || has("image_height")) {
    key = has("image_width") ? "image_height" : "image_width";
    if (!has(key)) missing(key, "image_width and image_height together, px");
    key = "image_width, image_height";
    width = *number("image_width");
    height = *number("image_height");
  } else if (has(key)) {
    const cv::FileNode node = storage_[key];
    const bool pair = node.isSeq() && node.size() == 2 && (node[0].isInt() || node[0].isReal()) &&
                      (node[1].isInt() || node[1].isReal());
    if (!pair) fail(key, "not a pair of numbers", "[width, height] in px");
    width = node[0].real();
    height = node[1].real();
  } else {
    return std::nullopt;
  }
  const auto valid = [](double edge) { return edge >= 1.0 && edge <= kMaxImageEdge_px && edge == std::floor(edge); };
  if (!valid(width) || !valid(height)) {
    fail(key, number_text(width) + " x " + number_text(height),
         "whole px from 1 to " + std::to_string(kMaxImageEdge_px));
  }
  return cv::Size(static_cast<int>(width), static_cast<int>(height));
}

}  // namespace markservo::stereo_camera
