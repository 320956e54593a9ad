#include "services/stereo-camera/devices/device_source.hpp"

#include <cmath>
#include <utility>

#include "services/stereo-camera/pairs/frame_pairing.hpp"
#include "services/stereo-camera/pairs/side_by_side.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kMicroseconds = 1e6;  // in a second

ReadResult result(ReadStatus status, const std::string& reason) {
  return {status, {}, reason};
}

}  // namespace

DeviceSource::DeviceSource(DeviceOpener left, DeviceOpener right, double rate_hz)
    : two_cameras_(true), rate_hz_(rate_hz) {
  left_.open = std::move(left);
  right_.open = std::move(right);
}

DeviceSource::DeviceSource(DeviceOpener side_by_side, double rate_hz) : two_cameras_(false), rate_hz_(rate_hz) {
  left_.open = std::move(side_by_side);
}

ReadResult DeviceSource::read() {
  std::string reason;
  if (!open(reason) || !grab(reason)) {
    close();
    return result(ReadStatus::kWaiting, reason);
  }
  ReadResult pair = two_cameras_ ? read_two() : read_side_by_side();
  pair.pair.index = next_index_++;
  return pair;
}

bool DeviceSource::open(std::string& reason) {
  if (!left_.device) left_.device = left_.open(reason);
  if (!left_.device) return false;
  if (two_cameras_ && !right_.device) right_.device = right_.open(reason);
  return !two_cameras_ || right_.device;
}

void DeviceSource::close() {
  left_.device.reset();
  right_.device.reset();
  left_.holds_frame = false;
  right_.holds_frame = false;
}

bool DeviceSource::grab(std::string& reason) {
  // Both are grabbed before either is decoded: decoding takes milliseconds.
  for (Camera* camera : {&left_, &right_}) {
    if (!camera->device || camera->holds_frame) continue;
    if (!camera->device->grab()) {
      reason = std::string(camera == &right_ ? "right"
                           : two_cameras_    ? "left"
                                             : "side-by-side") +
               " camera gives no frames any more";
      return false;
    }
    camera->holds_frame = true;
  }
  return true;
}

ReadResult DeviceSource::read_two() {
  const std::int64_t left_us = left_.device->utime();
  const std::int64_t right_us = right_.device->utime();
  const double rate = left_.device->rate() > 0.0 ? left_.device->rate() : rate_hz_;
  const auto period_us = static_cast<std::int64_t>(std::llround(kMicroseconds / rate));
  switch (pair_frames(left_us, right_us, period_us)) {
    case Pairing::kDropLeft:
      left_.holds_frame = false;
      return result(ReadStatus::kDropped, "left frame has no partner within half a frame");
    case Pairing::kDropRight:
      right_.holds_frame = false;
      return result(ReadStatus::kDropped, "right frame has no partner within half a frame");
    case Pairing::kPair:
      break;
  }
  left_.holds_frame = false;
  right_.holds_frame = false;
  RawPair pair;
  pair.left = left_.device->retrieve();
  pair.right = right_.device->retrieve();
  if (pair.left.empty() || pair.right.empty()) {
    return result(ReadStatus::kDropped, std::string(pair.left.empty() ? "left" : "right") + " frame is damaged");
  }
  // The middle of both, so that neither side is favoured.
  pair.exposure_utime = left_us + (right_us - left_us) / 2;
  return {ReadStatus::kPair, std::move(pair), ""};
}

ReadResult DeviceSource::read_side_by_side() {
  left_.holds_frame = false;
  const std::int64_t utime = left_.device->utime();
  const cv::Mat both = left_.device->retrieve();
  if (both.empty()) return result(ReadStatus::kDropped, "frame is damaged");
  const auto halves = split_side_by_side(both);
  if (!halves) {
    return result(ReadStatus::kDropped,
                  "side-by-side picture is " + size_text(both.size()) + "; allowed: an even width");
  }
  return {ReadStatus::kPair, {halves->left, halves->right, 0, utime}, ""};
}

}  // namespace markservo::stereo_camera
