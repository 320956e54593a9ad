#include "services/mark-detector/learning/mark_learning.hpp"

#include <utility>

#include "services/mark-detector/colour/colour_overlap.hpp"
#include "services/mark-detector/learning/learning_check.hpp"
#include "services/mark-detector/learning/robot_file_edit.hpp"

namespace markservo::mark_detector {
namespace {

LearnedView view_of_mark(const MarkDetector& detector, std::size_t mark, const LearningPicture& picture,
                         double mark_px2) {
  Input input;
  input.left = picture.image;
  State state;
  const View& view = detector.step(input, state).marks.at(mark).left;
  LearnedView learned;
  learned.doubt = doubt_about_learning(detector, mark, picture, mark_px2);
  if (view.seen) learned.found = view.region;
  return learned;
}

}  // namespace

MarkLearning learn_mark(std::vector<robot::MarkDescription> marks, std::size_t mark,
                        const std::vector<LearningPicture>& pictures, const LearningParameters& learning,
                        const Parameters& detection) {
  MarkLearning learned;
  learned.colour = learn_colour(pictures, learning);
  if (!learned.colour.failure.empty()) return learned;

  robot::MarkDescription& renewed = marks.at(mark);
  renewed.colour = learned.colour.interval;
  for (const robot::MarkDescription& other : marks) {
    if (other.name == renewed.name || !overlap(renewed.colour, other.colour)) continue;
    learned.overlaps.push_back({other.name, renewed.name + " overlaps " + other.name + ", " + to_text(other.colour) +
                                                ": what has both colours is taken for both"});
  }
  const MarkDetector detector(std::move(marks), detection);
  for (std::size_t i = 0; i < pictures.size(); ++i) {
    learned.views.push_back(view_of_mark(detector, mark, pictures[i], learned.colour.mark_px2[i]));
  }
  return learned;
}

BoxMask mask_over_box(const Region& found, const LearningPicture& picture) {
  const auto bytes_per_row = (static_cast<std::size_t>(picture.width) + 7) / 8;
  BoxMask mask;
  mask.bits.resize(bytes_per_row * static_cast<std::size_t>(picture.height));
  std::int64_t count = 0;
  for (int v = 0; v < picture.height; ++v) {
    for (int u = 0; u < picture.width; ++u) {
      if (!found.test(picture.x + u, picture.y + v)) continue;
      const std::size_t byte = static_cast<std::size_t>(v) * bytes_per_row + static_cast<std::size_t>(u) / 8;
      mask.bits[byte] = static_cast<std::uint8_t>(mask.bits[byte] | 1U << (u % 8));
      ++count;
    }
  }
  mask.covered = static_cast<double>(count) / (double(picture.width) * picture.height);
  return mask;
}

}  // namespace markservo::mark_detector
