#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "services/stereo-camera/files/image_stream.hpp"
#include "services/stereo-camera/files/video_decoder.hpp"

namespace markservo::stereo_camera {

// A video file. Ends where no further picture can be decoded.
class VideoStream : public ImageStream {
 public:
  // Pictures carry the time that the file states; where it states none, or none that rises, a period more than the one
  // before. With `rate_hz` (above 0) they carry their number by that rate instead. Throws ConfigurationError where the
  // file is not there or no video; `option` names the setting in the message.
  VideoStream(const std::string& path, const std::string& option, std::optional<double> rate_hz = std::nullopt);

  StreamResult next() override;
  void rewind() override;
  double rate() const override { return rate_hz_.value_or(decoder_->rate()); }

 private:
  std::int64_t time_of_next(const std::optional<std::int64_t>& stated_us) const;

  std::string path_;
  std::string option_;
  std::optional<double> rate_hz_;
  std::unique_ptr<VideoDecoder> decoder_;
  std::int64_t count_ = 0;  // pictures so far
  std::int64_t last_us_ = 0;
};

}  // namespace markservo::stereo_camera
