#include "services/mark-detector/learning/learning_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "services/mark-detector/learning/percent.hpp"

namespace markservo::mark_detector {
namespace {

struct Rectangle {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;

  double area() const { return double(right - left) * (bottom - top); }
};

// Pixels of a region within a rectangle.
double area_within(const Region& region, const Rectangle& rectangle) {
  double area = 0.0;
  for (int v = std::max(rectangle.top, region.y); v < std::min(rectangle.bottom, region.y + region.height); ++v) {
    for (int u = std::max(rectangle.left, region.x); u < std::min(rectangle.right, region.x + region.width); ++u) {
      area += region.test(u, v) ? 1.0 : 0.0;
    }
  }
  return area;
}

// The box with a margin around it, within the picture.
Rectangle widened(const LearningPicture& picture, int across, int down) {
  return {std::max(0, picture.x - across), std::max(0, picture.y - down),
          std::min(picture.image.width, picture.x + picture.width + across),
          std::min(picture.image.height, picture.y + picture.height + down)};
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
  const Rectangle box = widened(picture, 0, 0);
  const Rectangle around = widened(picture, margin(picture.width), margin(picture.height));
  const double near = area_within(found, around);
  const double in_box = area_within(found, box);
  const Shape& shape = finding.left.shape;
  const double all = area_within(found, {found.x, found.y, found.x + found.width, found.y + found.height});
  const std::string place = fmt::format("{},{},{},{}", shape.x, shape.y, shape.width, shape.height);
  if (near <= 0.0) return "something of its colour is found at " + place + ", outside the box";
  const std::string why_more = "something around it has its colour, or the box is too small";
  if (all - near > parameters.outgrown_share * all) {
    return fmt::format("it outgrows the box: {} of what is found, at {}, lies outside; {}", percent((all - near) / all),
                       place, why_more);
  }
  const double rim = around.area() - box.area();
  if (near - in_box > parameters.rim_share * rim) {
    return fmt::format("it outgrows the box: it is found on {} of the {} px around it, at {}; {}",
                       percent((near - in_box) / rim), margin(std::max(picture.width, picture.height)), place,
                       why_more);
  }
  if (near < parameters.covered_share * mark_px2) {
    return fmt::format("only {} of it is found, at {}; its colours are too many, or also those around it",
                       percent(near / mark_px2), place);
  }
  return {};
}

}  // namespace markservo::mark_detector
