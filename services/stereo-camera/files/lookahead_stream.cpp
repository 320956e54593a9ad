#include "services/stereo-camera/files/lookahead_stream.hpp"

#include <utility>

namespace markservo::stereo_camera {
namespace {

constexpr std::size_t kAhead = 2;  // the next picture and the one after it

}  // namespace

LookaheadStream::LookaheadStream(std::unique_ptr<ImageStream> stream, std::int64_t shift_us)
    : stream_(std::move(stream)), shift_us_(shift_us) {
  fill();
}

Upcoming LookaheadStream::upcoming() const {
  Upcoming upcoming{ahead_.front().time_us, std::nullopt};
  if (ahead_.size() == kAhead) upcoming.after_us = ahead_.back().time_us;
  return upcoming;
}

StreamResult LookaheadStream::take() {
  StreamResult next = std::move(ahead_.front());
  ahead_.pop_front();
  ++taken_;
  fill();
  return next;
}

void LookaheadStream::rewind() {
  stream_->rewind();
  ahead_.clear();
  taken_ = 0;
  fill();
}

void LookaheadStream::fill() {
  while (ahead_.size() < kAhead) {
    StreamResult result = stream_->next();
    if (result.status == StreamStatus::kEnd) return;
    result.time_us += shift_us_;
    ahead_.push_back(std::move(result));
  }
}

}  // namespace markservo::stereo_camera
