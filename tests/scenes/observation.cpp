#include "tests/scenes/observation.hpp"

namespace markservo::scenes {
namespace {

target_locator::View view_of(const mark_detector::View& found) {
  target_locator::View view;
  view.seen = found.seen;
  view.clipped = found.clipped;
  view.x = found.shape.x;
  view.y = found.shape.y;
  view.width = found.shape.width;
  view.height = found.shape.height;
  const mark_detector::Patch& patch = found.patch;
  if (patch.scale > 0) {
    view.patch.frame = {static_cast<double>(patch.x), static_cast<double>(patch.y), static_cast<double>(patch.scale)};
    view.patch.width = patch.width;
    view.patch.height = patch.height;
    view.patch.bgr = patch.bgr.data();
    view.patch.mask = patch.mask.data();
  }
  return view;
}

}  // namespace

mark_detector::ImageView view_of(const cv::Mat& image) {
  return {image.data, image.cols, image.rows, static_cast<std::ptrdiff_t>(image.step)};
}

target_locator::MarkObservation observation_of(const mark_detector::Finding& found,
                                               const robot::MarkDescription& mark) {
  target_locator::MarkObservation observation;
  observation.left = view_of(found.left);
  observation.right = view_of(found.right);
  observation.surface = static_cast<target_locator::Surface>(mark.surface);
  observation.outline = static_cast<target_locator::Outline>(mark.outline);
  observation.size = mark.size;
  return observation;
}

}  // namespace markservo::scenes
