#include "services/stereo-camera/files/file_source.hpp"

#include <utility>

#include "services/stereo-camera/pairs/side_by_side.hpp"

namespace markservo::stereo_camera {
namespace {

ReadResult dropped(const std::string& reason) {
  return {ReadStatus::kDropped, {}, reason};
}

}  // namespace

FileSource::FileSource(std::unique_ptr<ImageStream> left, std::unique_ptr<ImageStream> right, bool loop)
    : left_(std::move(left)), right_(std::move(right)), loop_(loop) {}

FileSource::FileSource(std::unique_ptr<ImageStream> side_by_side, bool loop)
    : left_(std::move(side_by_side)), loop_(loop) {}

ReadResult FileSource::read() {
  ReadResult result = right_ ? read_two() : read_side_by_side();
  if (result.status == ReadStatus::kEnd) return result;
  result.pair.index = next_index_++;
  if (result.status == ReadStatus::kPair) ++pairs_this_round_;
  return result;
}

ReadResult FileSource::read_two() {
  StreamResult left = left_->next();
  StreamResult right = right_->next();
  const bool left_ended = left.status == StreamStatus::kEnd;
  const bool right_ended = right.status == StreamStatus::kEnd;
  if (left_ended && right_ended) return end("");
  if (left_ended || right_ended) {
    return end(std::string(left_ended ? "left" : "right") + " ends after " + std::to_string(next_index_) +
               " pictures, the other side goes on; stopped at the shorter");
  }
  if (left.status == StreamStatus::kUnreadable) return dropped(left.reason);
  if (right.status == StreamStatus::kUnreadable) return dropped(right.reason);
  return {ReadStatus::kPair, {std::move(left.image), std::move(right.image), 0, std::nullopt}, ""};
}

ReadResult FileSource::read_side_by_side() {
  const StreamResult both = left_->next();
  if (both.status == StreamStatus::kEnd) return end("");
  if (both.status == StreamStatus::kUnreadable) return dropped(both.reason);
  const auto halves = split_side_by_side(both.image);
  if (!halves) {
    return dropped("side-by-side picture is " + size_text(both.image.size()) + "; allowed: an even width");
  }
  return {ReadStatus::kPair, {halves->left, halves->right, 0, std::nullopt}, ""};
}

ReadResult FileSource::end(const std::string& reason) {
  // A round without a single pair would be looped over for ever.
  if (!loop_ || pairs_this_round_ == 0) return {ReadStatus::kEnd, {}, reason};
  pairs_this_round_ = 0;
  left_->rewind();
  if (right_) right_->rewind();
  ReadResult result = right_ ? read_two() : read_side_by_side();
  if (result.reason.empty()) result.reason = reason;
  return result;
}

}  // namespace markservo::stereo_camera
