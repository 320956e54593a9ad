#include "services/stereo-camera/devices/v4l2_device.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <opencv2/videoio.hpp>
#include <utility>

#include "common/logging/log.hpp"
#include "services/stereo-camera/pairs/frame_pairing.hpp"
#include "services/stereo-camera/pairs/frame_source.hpp"

namespace markservo::stereo_camera {
namespace {

// OpenCV's driver reads this once: how long grab() waits for a frame, s. Its default of 10 would hide a lost camera.
constexpr const char* kSelectTimeoutVariable = "OPENCV_VIDEOIO_V4L_SELECT_TIMEOUT";
constexpr double kAutoExposure = 3.0;    // V4L2_EXPOSURE_APERTURE_PRIORITY
constexpr double kManualExposure = 1.0;  // V4L2_EXPOSURE_MANUAL
constexpr double kMicrosecondsPerMillisecond = 1e3;

std::int64_t clock_us(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return std::int64_t{1'000'000} * time.tv_sec + time.tv_nsec / 1000;
}

// Why the path is no camera that this process can open; empty when it may be one.
std::string path_complaint(const std::string& path) {
  struct stat status {};
  if (stat(path.c_str(), &status) != 0) {
    return path + ": there is no such device; allowed: a V4L2 camera (list them with: ls /dev/video*)";
  }
  if (!S_ISCHR(status.st_mode)) return path + ": is no camera device; allowed: a V4L2 camera such as /dev/video0";
  const int file = open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (file < 0) {
    const int error = errno;
    std::string hint = "allowed: a camera that can be opened";
    if (error == EACCES) hint = "allowed: a readable camera (add yourself to the group: usermod -aG video USER)";
    if (error == EBUSY) hint = "allowed: a camera that no other program holds";
    return path + ": " + std::strerror(error) + "; " + hint;
  }
  close(file);
  return "";
}

class V4l2Device : public CaptureDevice {
 public:
  explicit V4l2Device(const cv::VideoCapture& capture) : capture_(capture) {
    const double rate = capture_.get(cv::CAP_PROP_FPS);
    rate_ = std::isfinite(rate) && rate > 0.0 ? rate : 0.0;
  }

  bool grab() override {
    try {
      if (!capture_.grab()) return false;
    } catch (const cv::Exception& error) {
      logging::warn("camera: {}", error.err);
      return false;
    }
    // Read at once after the frame, so that the fallback is as near to it as can be.
    const auto driver_us =
        static_cast<std::int64_t>(std::llround(capture_.get(cv::CAP_PROP_POS_MSEC) * kMicrosecondsPerMillisecond));
    const FrameTime time = frame_time(driver_us, {clock_us(CLOCK_MONOTONIC), clock_us(CLOCK_REALTIME)});
    if (!time.from_driver && !std::exchange(told_no_times_, true)) {
      logging::warn("camera: the driver gives no usable frame times; the time of arrival is taken instead");
    }
    utime_ = time.utime;
    return true;
  }

  std::int64_t utime() override { return utime_; }

  cv::Mat retrieve() override {
    cv::Mat frame;
    try {
      if (!capture_.retrieve(frame)) return {};
    } catch (const cv::Exception&) {
      return {};
    }
    return frame.clone();  // the driver's buffer is used again by the next grab()
  }

  double rate() const override { return rate_; }

 private:
  cv::VideoCapture capture_;
  double rate_ = 0.0;
  std::int64_t utime_ = 0;
  bool told_no_times_ = false;
};

// Sets and reads back.
void apply(cv::VideoCapture& capture, const std::string& path, int property, double value, const char* name) {
  capture.set(property, value);
  const double taken = capture.get(property);
  if (std::abs(taken - value) > 0.5) {
    logging::warn("{}: {} was set to {}, the driver says {}", path, name, value, taken);
  }
}

}  // namespace

std::unique_ptr<CaptureDevice> open_v4l2(const V4l2Settings& settings, std::string& reason) {
  setenv(kSelectTimeoutVariable, "1", 0);
  reason = path_complaint(settings.path);
  if (!reason.empty()) return nullptr;
  cv::VideoCapture capture;
  try {
    if (!capture.open(settings.path, cv::CAP_V4L2)) {
      reason = settings.path + ": gives no video; allowed: a V4L2 capture device that no other program holds";
      return nullptr;
    }
    const std::string& path = settings.path;
    // The format first: it decides which sizes and rates there are.
    apply(capture, path, cv::CAP_PROP_FOURCC, cv::VideoWriter::fourcc('M', 'J', 'P', 'G'), "format MJPG");
    capture.set(cv::CAP_PROP_FRAME_WIDTH, settings.size.width);
    apply(capture, path, cv::CAP_PROP_FRAME_HEIGHT, settings.size.height, "height (px)");
    apply(capture, path, cv::CAP_PROP_FRAME_WIDTH, settings.size.width, "width (px)");
    apply(capture, path, cv::CAP_PROP_FPS, settings.rate_hz, "rate (Hz)");
    apply(capture, path, cv::CAP_PROP_BUFFERSIZE, 1.0, "buffers");
    apply(capture, path, cv::CAP_PROP_AUTOFOCUS, 0.0, "autofocus");
    apply(capture, path, cv::CAP_PROP_AUTO_EXPOSURE, kAutoExposure, "automatic exposure");
    if (settings.exposure) {
      // Some drivers take manual mode only after automatic mode was set.
      apply(capture, path, cv::CAP_PROP_AUTO_EXPOSURE, kManualExposure, "manual exposure");
      apply(capture, path, cv::CAP_PROP_EXPOSURE, *settings.exposure, "exposure");
    }
    apply(capture, path, cv::CAP_PROP_AUTO_WB, settings.auto_white_balance ? 1.0 : 0.0, "automatic white balance");
    if (settings.white_balance_K) {
      apply(capture, path, cv::CAP_PROP_WB_TEMPERATURE, *settings.white_balance_K, "white balance (K)");
    }
  } catch (const cv::Exception& error) {
    reason = settings.path + ": " + error.err;
    return nullptr;
  }
  return std::make_unique<V4l2Device>(capture);
}

}  // namespace markservo::stereo_camera
