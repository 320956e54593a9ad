#include "services/mark-detector/learning/learn_messages.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <markservo/LearnWarning.hpp>
#include <markservo/StereoFrame.hpp>
#include <tuple>
#include <utility>

#include "common/messages/message_rules.hpp"

namespace markservo::mark_detector {
namespace {

// Of its sizes: its pictures are not there.
std::string objection_to_frame(const LearnRequest& request) {
  StereoFrame frame = request.frame;
  frame.left_size = frame.right_size = request.left_size;
  const std::string why = messages::broken_rule(frame);
  return why.empty() ? "" : "the frame's " + why;
}

// A JPEG is smaller than what it shows.
std::string objection_to_piece(const LearnRequest& request) {
  const std::int64_t most = std::int64_t{3} * request.frame.width * request.frame.height;
  if (request.left_size < 1 || request.left_size > most) {
    return fmt::format("left_size is {}; allowed: 1 to width * height * 3 bytes", request.left_size);
  }
  if (request.offset >= 0 && request.piece_size >= 1 && request.piece_size <= request.left_size &&
      request.offset <= request.left_size - request.piece_size) {
    return {};
  }
  return fmt::format("the piece is {} bytes from {} on; allowed: 1 or more, within the picture's {}",
                     request.piece_size, request.offset, request.left_size);
}

void warn(LearnResult& result, const std::string& overlaps, const std::string& text) {
  LearnWarning warning;
  warning.overlaps = overlaps;
  warning.text = text;
  result.warnings.push_back(warning);
  result.num_warnings = static_cast<std::int32_t>(result.warnings.size());
}

}  // namespace

std::string objection_to(const LearnRequest& request) {
  if (std::string why = objection_to_frame(request); !why.empty()) return why;
  if (std::string why = objection_to_piece(request); !why.empty()) return why;
  const auto& [x, y, width, height] = std::tie(request.x, request.y, request.width, request.height);
  // Without sums, which could overflow.
  const bool inside = x >= 0 && y >= 0 && width >= 1 && height >= 1 && width <= request.frame.width &&
                      height <= request.frame.height && x <= request.frame.width - width &&
                      y <= request.frame.height - height;
  if (inside) return {};
  return fmt::format("the box is {},{},{},{}; allowed: x,y,width,height, sizes from 1, inside the frame's {} x {} px",
                     x, y, width, height, request.frame.width, request.frame.height);
}

LearnResult answer_to(const LearnRequest& request) {
  LearnResult result{};
  result.utime = request.utime;
  result.request_session = request.session;
  result.request_id = request.request_id;
  result.mark = request.mark;
  return result;
}

void fill(LearnResult& result, const MarkLearning& learned, const LearningPicture& picture) {
  const LearnedColour& colour = learned.colour;
  result.reason = colour.failure;
  if (!colour.failure.empty()) return;
  result.learned = 1;
  result.hue_min_deg = colour.interval.hue_min_deg;
  result.hue_max_deg = colour.interval.hue_max_deg;
  result.saturation_min = colour.interval.saturation_min;
  result.saturation_max = colour.interval.saturation_max;
  result.value_min = colour.interval.value_min;
  result.value_max = colour.interval.value_max;

  const LearnedView& view = learned.views.front();
  BoxMask mask = mask_over_box(view.found, picture);
  result.covered = mask.covered;
  result.mask_width = picture.width;
  result.mask_height = picture.height;
  result.mask_size = static_cast<std::int32_t>(mask.bits.size());
  result.mask = std::move(mask.bits);
  if (!colour.doubt.empty()) warn(result, "", colour.doubt);
  if (!view.doubt.empty()) warn(result, "", view.doubt);
  for (const OverlappingMark& other : learned.overlaps) warn(result, other.name, other.text);
}

}  // namespace markservo::mark_detector
