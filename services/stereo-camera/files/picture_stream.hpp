#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "services/stereo-camera/files/image_stream.hpp"

namespace markservo::stereo_camera {

// Picture files (PNG, JPEG and what else OpenCV reads), one after the other. A file that cannot be read is reported and
// passed over.
class PictureStream : public ImageStream {
 public:
  explicit PictureStream(std::vector<std::string> paths) : paths_(std::move(paths)) {}

  StreamResult next() override;
  void rewind() override { position_ = 0; }
  double rate() const override { return 0.0; }

 private:
  std::vector<std::string> paths_;
  std::size_t position_ = 0;
};

}  // namespace markservo::stereo_camera
