#include "services/mark-detector/picture/picture_options.hpp"

#include <filesystem>
#include <iostream>
#include <opencv2/core.hpp>
#include <utility>

#include "common/bus/options.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/mark-detector/picture/picture.hpp"
#include "services/mark-detector/picture/picture_file.hpp"

namespace markservo::mark_detector {
namespace {

void require_same_size(const cv::Mat& right, const std::string& right_file, const cv::Mat& left) {
  if (right.size() == left.size()) return;
  throw ConfigurationError("--right '" + right_file + "': " + std::to_string(right.cols) + " x " +
                           std::to_string(right.rows) + " px; allowed: the size of --image, " +
                           std::to_string(left.cols) + " x " + std::to_string(left.rows) + " px");
}

}  // namespace

void PictureOptions::add_to(CLI::App& app) {
  const bus::Options add(app);
  const char* const group = "Picture without a bus";
  add.option("--image", image_file_, "Look at this picture, print JSON and exit").not_in_config().group(group);
  add.option("--right", right_file_, "The right camera's picture").not_in_config().group(group);
  add.option("--annotate", annotated_file_, "Write the picture with what was found").not_in_config().group(group);
  add.option("--mask-dir", mask_folder_, "Write each mark's mask into this folder").not_in_config().group(group);
  add.flag("--all-blobs", all_blobs_, "Also every blob of a mark's colour, in JSON and masks")
      .not_in_config()
      .group(group);
}

void PictureOptions::check() const {
  if (wanted()) return;
  for (const auto& [option, value] : {std::pair{"--right", right_file_}, std::pair{"--annotate", annotated_file_},
                                      std::pair{"--mask-dir", mask_folder_}}) {
    if (!value.empty()) throw ConfigurationError(std::string(option) + ": without --image; allowed: with --image FILE");
  }
}

void PictureOptions::run(const MarkDetector& detector, bool equalised) const {
  const cv::Mat left = read_picture("--image", image_file_);
  cv::Mat right;
  if (!right_file_.empty()) {
    right = read_picture("--right", right_file_);
    require_same_size(right, right_file_, left);
  }
  Input input;
  input.left = view_of(left);
  if (!right.empty()) input.right = view_of(right);
  State state;
  const Output& output = detector.step(input, state);

  nlohmann::ordered_json json{{"image", image_file_}};
  if (!right.empty()) json["right"] = right_file_;
  json["width"] = left.cols;
  json["height"] = left.rows;
  json["equalised"] = equalised;
  json["marks"] = report(output, !right.empty(), all_blobs_);
  std::cout << json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) << "\n";

  if (!annotated_file_.empty()) write_picture("--annotate", annotated_file_, annotate(left, right, output));
  if (!mask_folder_.empty()) {
    std::error_code failed;
    std::filesystem::create_directories(mask_folder_, failed);
    for (const NamedMask& mask : masks(output, left.size(), all_blobs_)) {
      write_picture("--mask-dir", (std::filesystem::path(mask_folder_) / mask.name).string(), mask.mask);
    }
  }
}

}  // namespace markservo::mark_detector
