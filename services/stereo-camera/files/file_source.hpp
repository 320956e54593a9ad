#pragma once

#include <memory>
#include <string>

#include "services/stereo-camera/files/image_stream.hpp"
#include "services/stereo-camera/pairs/frame_source.hpp"

namespace markservo::stereo_camera {

// Pairs from files: two streams, or one with both views side by side. A picture that cannot be used costs its pair;
// where one stream is shorter, both end there.
class FileSource : public FrameSource {
 public:
  FileSource(std::unique_ptr<ImageStream> left, std::unique_ptr<ImageStream> right, bool loop);
  FileSource(std::unique_ptr<ImageStream> side_by_side, bool loop);

  ReadResult read() override;

  // Frames per second as the files state it; 0 where they do not.
  double rate() const { return left_->rate(); }

 private:
  ReadResult read_two();
  ReadResult read_side_by_side();
  ReadResult end(const std::string& reason);

  std::unique_ptr<ImageStream> left_;
  std::unique_ptr<ImageStream> right_;  // none where the left one has both views
  bool loop_;
  std::int64_t next_index_ = 0;
  std::int64_t pairs_this_round_ = 0;
};

}  // namespace markservo::stereo_camera
