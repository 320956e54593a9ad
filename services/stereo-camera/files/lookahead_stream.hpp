#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>

#include "services/stereo-camera/files/image_stream.hpp"
#include "services/stereo-camera/pairs/frame_pairing.hpp"

namespace markservo::stereo_camera {

// A stream of which the next picture and the one after it can be looked at before they are taken.
class LookaheadStream {
 public:
  // `shift_us` is added to all times.
  LookaheadStream(std::unique_ptr<ImageStream> stream, std::int64_t shift_us);

  bool ended() const { return ahead_.empty(); }

  // Only where it has not ended.
  Upcoming upcoming() const;
  StreamResult take();

  // Back to the first picture.
  void rewind();

  std::int64_t taken() const { return taken_; }  // pictures since the beginning or the last rewind()
  double rate() const { return stream_->rate(); }

 private:
  void fill();

  std::unique_ptr<ImageStream> stream_;
  std::int64_t shift_us_;
  std::deque<StreamResult> ahead_;
  std::int64_t taken_ = 0;
};

}  // namespace markservo::stereo_camera
