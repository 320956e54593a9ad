#include "services/stereo-camera/files/video_stream.hpp"

#include <filesystem>
#include <stdexcept>
#include <system_error>

#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/files/schedule.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kUsualRate_hz = 30.0;  // of a video that states neither rate nor times

}  // namespace

VideoStream::VideoStream(const std::string& path, const std::string& option, std::optional<double> rate_hz)
    : path_(path), option_(option), rate_hz_(rate_hz) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) {
    throw ConfigurationError(option + " is '" + path +
                             "', which is no file; allowed: a picture, a video, or a pattern "
                             "as left_%02d.png");
  }
  VideoStream::rewind();  // not virtual while it is being made
}

StreamResult VideoStream::next() {
  StreamResult result;
  std::optional<VideoPicture> picture = decoder_->next();
  if (!picture) return result;
  result.status = StreamStatus::kImage;
  result.image = std::move(picture->image);
  result.time_us = time_of_next(picture->time_us);
  last_us_ = result.time_us;
  ++count_;
  return result;
}

std::int64_t VideoStream::time_of_next(const std::optional<std::int64_t>& stated_us) const {
  if (rate_hz_) return time_of(0, count_, *rate_hz_);
  const bool rises = stated_us && (count_ == 0 || *stated_us > last_us_);
  if (rises) return *stated_us;
  if (count_ == 0) return 0;
  const double rate = decoder_->rate();
  return time_of(last_us_, 1, rate > 0.0 ? rate : kUsualRate_hz);
}

void VideoStream::rewind() {
  // Opened afresh: seeking is inexact in many containers.
  try {
    decoder_ = std::make_unique<VideoDecoder>(path_);
  } catch (const std::runtime_error& error) {
    throw ConfigurationError(option_ + " is '" + path_ + "', which is no readable video (" + error.what() +
                             "); allowed: what FFmpeg decodes");
  }
  count_ = 0;
  last_us_ = 0;
}

}  // namespace markservo::stereo_camera
