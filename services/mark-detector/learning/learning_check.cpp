#include "services/mark-detector/learning/learning_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "services/mark-detector/learning/percent.hpp"

namespace markservo::mark_detector {
namespace {

// Pixels of a region within a rectangle.
double area_within(const Region& region, int left, int top, int right, int bottom) {
  double area = 0.0;
  for (int v = std::max(top, region.y); v < std::min(bottom, region.y + region.height); ++v) {
    for (int u = std::max(left, region.x); u < std::min(right, region.x + region.width); ++u) {
      area += region.test(u, v) ? 1.0 : 0.0;
    }
  }
  return area;
}

}  // namespace

std::string doubt_about_learning(const MarkDetector& detector, std::size_t mark, const LearningPicture& picture,
                                 double mark_px2, const LearningCheckParameters& parameters) {
  Input input;
  input.left = picture.image;
  State state;
  const Finding& finding = detector.step(input, state).marks.at(mark);
  if (!finding.left.seen) return "it is not found there: " + finding.reason;

  const Region& found = finding.left.region;
  const auto margin = [&](int edge) {
    return std::max(parameters.margin_least, static_cast<int>(std::ceil(parameters.margin_share * edge)));
  };
  const int across = margin(picture.width);
  const int down = margin(picture.height);
  const double near = area_within(found, picture.x - across, picture.y - down, picture.x + picture.width + across,
                                  picture.y + picture.height + down);
  const Shape& shape = finding.left.shape;
  const double all = area_within(found, found.x, found.y, found.x + found.width, found.y + found.height);
  const std::string place = fmt::format("{},{},{},{}", shape.x, shape.y, shape.width, shape.height);
  if (near <= 0.0) return "something of its colour is found at " + place + ", outside the box";
  if (all - near > parameters.outgrown_share * all) {
    return fmt::format(
        "it outgrows the box: {} of what is found, at {}, lies outside; something around it has its "
        "colour, or the box is too small",
        percent((all - near) / all), place);
  }
  if (near < parameters.covered_share * mark_px2) {
    return fmt::format("only {} of it is found, at {}; its colours are too many, or also those around it",
                       percent(near / mark_px2), place);
  }
  return {};
}

}  // namespace markservo::mark_detector
