#pragma once

// A sheet of paper with a mark to cut out and glue on, printed in the manner of the simulated world's.

#include <opencv2/core.hpp>
#include <string>

#include "common/robot/robot_description.hpp"
#include "services/simulator/scene/scene.hpp"

namespace markservo::simulator {

struct SheetParameters {
  double width = 0.210;  // m: A4
  double height = 0.297;
  double dots_per_metre = 600.0 / 0.0254;
  double margin = 0.020;   // m, more than any printer leaves white
  double ruler = 0.050;    // m, a line to measure: printers like to scale
  double tick = 0.005;     // m, of the lines along which to cut
  double line = 0.000125;  // m, thickness
};

// CV_8UC3, blue first: the mark in its true size, lines to cut along beside its corners, and a ruler to check the scale
// by. Throws ConfigurationError if the mark does not fit the sheet.
cv::Mat print_sheet(const robot::MarkDescription& mark, const PrintScene& print,
                    const SheetParameters& parameters = SheetParameters());

}  // namespace markservo::simulator
