#pragma once

// Pictures that a person asks the simulator for, without a bus.

#include <opencv2/core.hpp>
#include <string>

#include "common/robot/robot_description.hpp"
#include "services/simulator/scene/scene.hpp"

namespace CLI {
class App;
}

namespace markservo::simulator {

struct PictureOptions {
  std::string snapshot;    // file for one picture pair; empty: none is asked for
  std::string print_mark;  // name of a mark to print; empty: none
  std::string print_to = "mark.png";
};

void add_picture_options(CLI::App& app, PictureOptions& options);

// Writes the sheet with the mark `options.print_mark`. Throws ConfigurationError for a mark that the robot has not, or
// that fits no sheet, and for a file that cannot be written.
void write_print_sheet(const PictureOptions& options, const robot::RobotDescription& robot,
                       const std::string& robot_file, const Scene& scene);

// Likewise the two pictures side by side to `options.snapshot`.
void write_snapshot(const PictureOptions& options, const cv::Mat& left, const cv::Mat& right);

}  // namespace markservo::simulator
