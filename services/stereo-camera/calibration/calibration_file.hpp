#pragma once

// Reading and checking single entries of an OpenCV calibration file. Every error is a ConfigurationError with file,
// key, value and what is allowed.

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace markservo::stereo_camera {

// An opened OpenCV YAML, XML or JSON file.
class CalibrationFile {
 public:
  // Throws ConfigurationError for a file that is not there, has no header or is not well-formed.
  explicit CalibrationFile(const std::string& path);

  bool has(const std::string& key) const;

  // The first of `keys` that the file has, or the first of them.
  std::string first_of(const std::vector<std::string>& keys) const;

  // A matrix of double with exactly `rows` x `cols` finite numbers.
  cv::Mat matrix(const std::string& key, int rows, int cols) const;

  // [fx s cx; 0 fy cy; 0 0 1] with fx, fy above 0.
  cv::Matx33d camera_matrix(const std::string& key) const;

  // Distortion coefficients as OpenCV's pinhole model takes them: 4, 5, 8, 12 or 14 in a row or a column.
  cv::Mat distortion(const std::string& key) const;

  // An orthonormal 3 x 3 matrix with determinant +1.
  cv::Matx33d rotation(const std::string& key) const;

  // A 3 x 4 projection [f 0 cx tx; 0 f cy ty; 0 0 1 0] with f above 0.
  cv::Matx34d projection(const std::string& key) const;

  // A number, or nothing where the key is absent.
  std::optional<double> number(const std::string& key) const;

  // Width and height, px: image_width and image_height, or image_size as [width, height]. Nothing where both are
  // absent.
  std::optional<cv::Size> image_size() const;

  [[noreturn]] void fail(const std::string& key, const std::string& value, const std::string& allowed) const;
  [[noreturn]] void missing(const std::string& key, const std::string& allowed) const;

 private:
  cv::Mat any_matrix(const std::string& key) const;

  std::string path_;
  cv::FileStorage storage_;
};

}  // namespace markservo::stereo_camera
