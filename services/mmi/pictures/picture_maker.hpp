#pragma once

#include <memory>
#include <string>

#include "services/mmi/pictures/frame_ring.hpp"
#include "services/mmi/pictures/jpeg_encoder.hpp"

namespace markservo::mmi {

// The two pictures of a frame as JPEG files.
struct JpegPair {
  int width = 0;   // px
  int height = 0;  // px
  std::string left;
  std::string right;
};

// Whether a STEREO_FRAME, decoded, can be shown: an encoding that is known, and sizes that go together.
bool is_picture(const reflection::Fields& frame);

// Frames as what a browser shows. JPEG files of a frame pass as they are; the frame last made is kept, for the next
// client.
class PictureMaker {
 public:
  // Null where the frame's bytes are none: an encoding that is not known, sizes that contradict each other.
  std::shared_ptr<const JpegPair> jpegs(const std::shared_ptr<const Frame>& frame);

  // The frame's JPEG files and answers, as the README has a picture but without its length and `number`, which are each
  // client's own: {"frame_session": ... "servo": ...} without the first brace, and both files.
  struct Made {
    std::string header;
    std::shared_ptr<const JpegPair> pair;
  };
  std::shared_ptr<const Made> made(const std::shared_ptr<const Frame>& frame);

 private:
  JpegEncoder encoder_;
  std::shared_ptr<const Frame> encoded_frame_;
  std::shared_ptr<const JpegPair> encoded_;
  std::shared_ptr<const Frame> made_frame_;
  std::array<Bytes, kFrameParts> made_parts_;
  std::shared_ptr<const Made> made_;
};

// A picture of the WebSocket.
std::string picture_message(const PictureMaker::Made& made, std::int64_t number);

}  // namespace markservo::mmi
