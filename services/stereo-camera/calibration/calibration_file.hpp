#pragma once

// Reading and checking single entries of a calibration file. Every error is a ConfigurationError with file, key, value
// and what is allowed. Where several keys are given, tools call the entry by any of them; the first that the file has
// counts.

#include <memory>
#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

namespace YAML {
class Node;  // without its header, which takes the compiler long
}

namespace markservo::stereo_camera {

class CalibrationFile {
 public:
  using Keys = std::vector<std::string>;

  // Throws ConfigurationError for a file that is not there or not well-formed.
  explicit CalibrationFile(const std::string& path);

  const std::string& path() const { return path_; }
  bool has(const Keys& keys) const;
  // The first of `keys` that the file has, or the first of them.
  const std::string& name(const Keys& keys) const;

  // A matrix of exactly `rows` x `cols` finite numbers: an !!opencv-matrix, rows, cols and data without that tag, a
  // list of rows, or all its numbers in one list.
  cv::Mat matrix(const Keys& keys, int rows, int cols) const;

  // Three numbers, in a row, a column or a list.
  cv::Vec3d vector3(const Keys& keys) const;

  // [fx 0 cx; 0 fy cy; 0 0 1] with fx, fy above 0: no skew, which neither lens model knows.
  cv::Matx33d camera_matrix(const Keys& keys) const;

  // Distortion coefficients in a row, a column or a list, 1 x n; `counts` are allowed.
  cv::Mat distortion(const Keys& keys, const std::vector<int>& counts) const;

  // An orthonormal 3 x 3 matrix with determinant +1, or three numbers: the axis times the angle, rad.
  cv::Matx33d rotation(const Keys& keys) const;

  // A 3 x 4 projection [f 0 cx tx; 0 f cy ty; 0 0 1 0] with f above 0.
  cv::Matx34d projection(const Keys& keys) const;

  // A number, or nothing where the key is absent.
  std::optional<double> number(const Keys& keys) const;

  // A text, or nothing where the key is absent.
  std::optional<std::string> text(const Keys& keys) const;

  // Width and height, px: in two keys, or image_size as [width, height]. Nothing where all are absent.
  std::optional<cv::Size> image_size() const;

  [[noreturn]] void fail(const std::string& key, const std::string& value, const std::string& allowed) const;
  [[noreturn]] void missing(const std::string& key, const std::string& allowed) const;

 private:
  cv::Mat any_matrix(const Keys& keys) const;
  std::vector<double> numbers(const std::string& key, const YAML::Node& list) const;

  std::string path_;
  std::shared_ptr<const YAML::Node> root_;
};

}  // namespace markservo::stereo_camera
