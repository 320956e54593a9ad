#pragma once

// What mark-detector finds in a picture, for people: JSON, an annotated picture, masks.

#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "services/mark-detector/detector_output.hpp"
#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

// The view of an 8-bit, three-channel BGR image, which must outlive it.
ImageView view_of(const cv::Mat& image);

// One object per mark: name, role, separability, reason, left and right (if there is a right image). `all_blobs` adds
// each image's blobs, the largest first. Numbers in px of the image.
nlohmann::ordered_json report(const Output& output, bool has_right, bool all_blobs);

// The image with each mark's outline, box, centroid and name; with a right image both, side by side.
cv::Mat annotate(const cv::Mat& left, const cv::Mat& right, const Output& output);

struct NamedMask {
  std::string name;  // of the file, without folder
  cv::Mat mask;      // 255 where the mark is
};

// MARK-left.png and MARK-right.png of each mark that is seen; with `all_blobs` also MARK-left-blob-0.png, the largest,
// and so on, holes filled as a mark's are, up to 64 a mark and side.
std::vector<NamedMask> masks(const Output& output, cv::Size size, bool all_blobs);

}  // namespace markservo::mark_detector
