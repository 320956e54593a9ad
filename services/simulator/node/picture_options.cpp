#include "services/simulator/node/picture_options.hpp"

#include <opencv2/imgcodecs.hpp>

#include "common/bus/options.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/require_mark.hpp"
#include "services/simulator/marks/print_sheet.hpp"

namespace markservo::simulator {
namespace {

void write_picture(const char* option, const std::string& file, const cv::Mat& picture) {
  bool written = false;
  try {
    written = cv::imwrite(file, picture);
  } catch (const cv::Exception&) {  // a file name that OpenCV knows no format for
  }
  if (written) return;
  throw ConfigurationError(std::string(option) + " is '" + file + "'; allowed: a .png or .jpg that can be written");
}

}  // namespace

void add_picture_options(CLI::App& app, PictureOptions& options) {
  const bus::Options add(app);
  add.option("--snapshot", options.snapshot, "Write one picture pair, side by side, to this file and exit")
      .not_in_config();
  const bus::Option mark =
      add.option("--print-mark", options.print_mark, "Write this mark in its true size, to be printed, and exit")
          .not_in_config();
  add.option("--print-to", options.print_to, "With --print-mark: the picture, an A4 page of 600 dots per inch")
      .needs(mark)
      .show_default()
      .not_in_config();
}

void write_print_sheet(const PictureOptions& options, const robot::RobotDescription& robot,
                       const std::string& robot_file, const Scene& scene) {
  const robot::MarkDescription& mark = robot::require_mark(robot, "--print-mark", options.print_mark, robot_file);
  write_picture("--print-to", options.print_to, print_sheet(mark, scene.print));
}

void write_snapshot(const PictureOptions& options, const cv::Mat& left, const cv::Mat& right) {
  cv::Mat both;
  cv::hconcat(left, right, both);
  write_picture("--snapshot", options.snapshot, both);
}

}  // namespace markservo::simulator
