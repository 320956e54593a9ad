#pragma once

// A stereo calibration as text, so that a test can spoil single keys of it.

#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace markservo::stereo_camera {

// One !!opencv-matrix.
inline std::string matrix_text(int rows, int cols, const std::vector<std::string>& values) {
  std::ostringstream text;
  text << "!!opencv-matrix\n   rows: " << rows << "\n   cols: " << cols << "\n   dt: d\n   data: [ ";
  for (std::size_t i = 0; i < values.size(); ++i) text << (i == 0 ? "" : ", ") << values[i];
  text << " ]";
  return text.str();
}

// Ideal cameras of 64 x 48 px, 0.1 m apart, f = 50 px: rectification changes nothing.
class CalibrationText {
 public:
  CalibrationText() {
    const std::vector<std::string> identity{"1.", "0.", "0.", "0.", "1.", "0.", "0.", "0.", "1."};
    const std::vector<std::string> K{"50.", "0.", "31.5", "0.", "50.", "23.5", "0.", "0.", "1."};
    const std::vector<std::string> D{"0.", "0.", "0.", "0.", "0."};
    keys_ = {{"image_width", "64"},
             {"image_height", "48"},
             {"rms", "0.2"},
             {"K1", matrix_text(3, 3, K)},
             {"D1", matrix_text(1, 5, D)},
             {"K2", matrix_text(3, 3, K)},
             {"D2", matrix_text(5, 1, D)},
             {"R", matrix_text(3, 3, identity)},
             {"T", matrix_text(3, 1, {"-0.1", "0.", "0."})},
             {"R1", matrix_text(3, 3, identity)},
             {"R2", matrix_text(3, 3, identity)},
             {"P1", projection("0.")},
             {"P2", projection("-5.")}};
  }

  static std::string projection(const std::string& tx) {
    return matrix_text(3, 4, {"50.", "0.", "31.5", tx, "0.", "50.", "23.5", "0.", "0.", "0.", "1.", "0."});
  }

  CalibrationText& set(const std::string& key, const std::string& value) {
    keys_[key] = value;
    return *this;
  }
  CalibrationText& remove(const std::string& key) {
    keys_.erase(key);
    return *this;
  }

  // Without the header.
  std::string body() const {
    std::ostringstream text;
    for (const auto& [key, value] : keys_) text << key << ": " << value << "\n";
    return text.str();
  }
  std::string text() const { return "%YAML:1.0\n---\n" + body(); }

 private:
  std::map<std::string, std::string> keys_;
};

}  // namespace markservo::stereo_camera
