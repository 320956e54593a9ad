#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "services/stereo-camera/files/image_stream.hpp"

namespace markservo::stereo_camera {

// A picture file and its place among all that were taken, from 0: times follow from it, so that what is missing leaves
// a gap.
struct PlacedPicture {
  std::int64_t place = 0;
  std::string path;
};

// Picture files (PNG, JPEG and what else OpenCV reads), one after the other. A file that cannot be read is reported and
// passed over.
class PictureStream : public ImageStream {
 public:
  // By rising places. `rate_hz` (above 0): places a second.
  PictureStream(std::vector<PlacedPicture> pictures, double rate_hz)
      : pictures_(std::move(pictures)), rate_hz_(rate_hz) {}

  StreamResult next() override;
  void rewind() override { position_ = 0; }
  double rate() const override { return rate_hz_; }

 private:
  std::vector<PlacedPicture> pictures_;
  double rate_hz_;
  std::size_t position_ = 0;
};

}  // namespace markservo::stereo_camera
