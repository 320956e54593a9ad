#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "services/stereo-camera/files/image_stream.hpp"
#include "services/stereo-camera/files/lookahead_stream.hpp"
#include "services/stereo-camera/pairs/frame_source.hpp"

namespace markservo::stereo_camera {

// Pairs from files: two streams, whose pictures are paired by their times, or one with both views side by side. A pair
// has the middle of its two pictures' times. A picture that cannot be used costs its pair, one without a partner within
// half a period is dropped; where one stream is shorter, both end there.
class FileSource : public FrameSource {
 public:
  // `right_ahead_us`: what the right stream's time is more than the left's at the same moment.
  FileSource(std::unique_ptr<ImageStream> left, std::unique_ptr<ImageStream> right, bool loop,
             std::int64_t right_ahead_us = 0);
  FileSource(std::unique_ptr<ImageStream> side_by_side, bool loop);

  ReadResult read() override;

  // Between two pictures of the faster stream, as the files state it; of 30 a second where they do not.
  std::int64_t period_us() const;

 private:
  ReadResult read_two();
  ReadResult pair_two();
  ReadResult read_side_by_side();
  ReadResult end(const std::string& reason);
  std::string reason_of_the_end() const;
  std::string reason_of_the_beginning() const;

  LookaheadStream left_;
  std::optional<LookaheadStream> right_;  // none where the left one has both views
  bool loop_;
  std::int64_t next_index_ = 0;
  std::int64_t matched_this_round_ = 0;  // of one time, readable or not
  std::int64_t pairs_this_round_ = 0;
  std::int64_t round_shift_us_ = 0;  // what this round's times are later than the files'
  std::int64_t last_us_ = 0;         // of the newest pair
};

}  // namespace markservo::stereo_camera
