#include "services/stereo-camera/source_options.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "common/logging/log.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/devices/device_source.hpp"
#include "services/stereo-camera/files/file_source.hpp"
#include "services/stereo-camera/files/picture_list.hpp"
#include "services/stereo-camera/files/picture_stream.hpp"
#include "services/stereo-camera/files/video_offset.hpp"
#include "services/stereo-camera/files/video_stream.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kMicroseconds = 1e6;  // in a second
constexpr double kMinRate_hz = 0.001;  // a pair in 17 minutes; times of much less do not fit into microseconds
constexpr double kMaxRate_hz = 1000.0;
constexpr double kRateTolerance = 0.01;  // two cameras of one kind state 29.97 and 30, or lose a picture now and then
constexpr double kMaxOffset_s = 1e6;     // clocks that are further apart are no two recordings of one scene

constexpr const char* kWays =
    "exactly one of: --left-device and --right-device; --device with --side-by-side; --left and --right; --input with "
    "--side-by-side";

void check_way(const SourceOptions& options) {
  const bool two_devices = !options.left_device.empty() || !options.right_device.empty();
  const bool two_files = !options.left.empty() || !options.right.empty();
  const std::array<bool, 4> ways{two_devices, !options.device.empty(), two_files, !options.input.empty()};
  int chosen = 0;
  for (const bool way : ways) chosen += way ? 1 : 0;
  if (chosen != 1) {
    throw ConfigurationError(std::string(chosen == 0 ? "no source of pictures is given" : "sources are mixed") +
                             "; allowed: " + kWays);
  }
  if (two_devices && (options.left_device.empty() || options.right_device.empty())) {
    throw ConfigurationError("only one of --left-device and --right-device is given; allowed: both");
  }
  if (two_files && (options.left.empty() || options.right.empty())) {
    throw ConfigurationError("only one of --left and --right is given; allowed: both, or --input with --side-by-side");
  }
  if (two_devices && options.left_device == options.right_device) {
    throw ConfigurationError("--left-device and --right-device are both '" + options.left_device +
                             "'; allowed: two cameras");
  }
  const bool one = !options.device.empty() || !options.input.empty();
  if (one != options.side_by_side) {
    throw ConfigurationError(std::string("--side-by-side is ") + (options.side_by_side ? "given" : "missing") +
                             "; allowed: with --device and --input, and only there");
  }
  if (options.loop && (two_devices || !options.device.empty())) {
    throw ConfigurationError("--loop is given with cameras; allowed: with files");
  }
  if (options.rate_hz && !(*options.rate_hz >= kMinRate_hz && *options.rate_hz <= kMaxRate_hz)) {
    throw ConfigurationError(
        fmt::format("--rate is {:.6g} Hz; allowed: {:.6g} to {:.6g}", *options.rate_hz, kMinRate_hz, kMaxRate_hz));
  }
}

void check_offset(const SourceOptions& options) {
  const bool two_videos = !options.left.empty() && !is_picture_name(options.left) && !is_picture_name(options.right);
  if (!two_videos && (options.offset_s || options.estimate_offset)) {
    throw ConfigurationError(std::string(options.offset_s ? "--offset-s" : "--estimate-offset") +
                             " is given without two videos; allowed: with videos as --left and --right");
  }
  if (options.offset_s && options.estimate_offset) {
    throw ConfigurationError("--offset-s and --estimate-offset are both given; allowed: one of them");
  }
  if (options.offset_s && !(std::abs(*options.offset_s) <= kMaxOffset_s)) {
    throw ConfigurationError(
        fmt::format("--offset-s is {} s; allowed: -{:.0f} to {:.0f}", *options.offset_s, kMaxOffset_s, kMaxOffset_s));
  }
}

DeviceOpener opener(V4l2Settings settings, const std::string& path, cv::Size size, double rate_hz) {
  settings.path = path;
  settings.size = size;
  settings.rate_hz = rate_hz;
  return [settings](std::string& reason) { return open_v4l2(settings, reason); };
}

OpenedSource open_devices(const SourceOptions& options, cv::Size view_size) {
  const double rate = options.rate_hz.value_or(kDefaultDeviceRate_hz);
  const cv::Size size(options.width > 0 ? options.width : view_size.width,
                      options.height > 0 ? options.height : view_size.height);
  OpenedSource opened;
  opened.live = true;
  if (options.side_by_side) {
    opened.source = std::make_unique<DeviceSource>(
        opener(options.camera, options.device, cv::Size(2 * size.width, size.height), rate), rate);
  } else {
    opened.source = std::make_unique<DeviceSource>(opener(options.camera, options.left_device, size, rate),
                                                   opener(options.camera, options.right_device, size, rate), rate);
  }
  return opened;
}

std::unique_ptr<FileSource> open_videos(const SourceOptions& options, OpenedSource& opened) {
  auto left = std::make_unique<VideoStream>(options.left, "--left", options.rate_hz);
  auto right = std::make_unique<VideoStream>(options.right, "--right", options.rate_hz);
  if (std::abs(left->rate() - right->rate()) > kRateTolerance * left->rate()) {
    opened.warnings.push_back(fmt::format(
        "--left has {:.6g} pictures a second, --right {:.6g}: only those within half a period of the faster "
        "one are paired, and what moves is not seen at one moment",
        left->rate(), right->rate()));
  }
  double offset_s = options.offset_s.value_or(0.0);
  if (!options.offset_s && !options.rate_hz) {
    opened.note = "both videos' times are taken for one clock's; --estimate-offset asks the pictures";
  }
  if (options.estimate_offset) {
    logging::info("--estimate-offset: looking for what moves in both videos' first minute");
    const OffsetEstimate estimate = measure_offset(*left, *right);
    offset_s = estimate.offset_s;
    opened.note = fmt::format(
        "the right video's time is {:.3f} s more than the left's (what moves in both correlates by "
        "{:.2f} over {:.1f} s): --offset-s {:.3f}",
        offset_s, estimate.correlation, estimate.overlap_s, offset_s);
  }
  return std::make_unique<FileSource>(std::move(left), std::move(right), options.loop,
                                      std::llround(kMicroseconds * offset_s));
}

std::unique_ptr<FileSource> open_side_by_side(const SourceOptions& options, double picture_rate_hz) {
  std::unique_ptr<ImageStream> both;
  if (is_picture_name(options.input)) {
    both = std::make_unique<PictureStream>(placed(expand_pattern(options.input, "--input")), picture_rate_hz);
  } else {
    both = std::make_unique<VideoStream>(options.input, "--input", options.rate_hz);
  }
  return std::make_unique<FileSource>(std::move(both), options.loop);
}

OpenedSource open_files(const SourceOptions& options) {
  OpenedSource opened;
  std::unique_ptr<FileSource> source;
  const double picture_rate_hz = options.rate_hz.value_or(kDefaultFileRate_hz);
  if (options.side_by_side) {
    source = open_side_by_side(options, picture_rate_hz);
  } else if (is_picture_name(options.left) && is_picture_name(options.right)) {
    const auto left = expand_pattern(options.left, "--left");
    PairedPictures pairs = pair_by_number(left, expand_pattern(options.right, "--right"));
    if (!pairs.note.empty()) opened.warnings.push_back(pairs.note);
    source = std::make_unique<FileSource>(std::make_unique<PictureStream>(std::move(pairs.left), picture_rate_hz),
                                          std::make_unique<PictureStream>(std::move(pairs.right), picture_rate_hz),
                                          options.loop);
  } else if (is_picture_name(options.left) != is_picture_name(options.right)) {
    throw ConfigurationError("--left is '" + options.left + "' and --right is '" + options.right +
                             "'; allowed: pictures on both sides or videos on both sides");
  } else {
    source = open_videos(options, opened);
  }
  opened.period_us = source->period_us();
  opened.source = std::move(source);
  return opened;
}

}  // namespace

OpenedSource open_source(const SourceOptions& options, cv::Size view_size) {
  check_way(options);
  check_offset(options);
  if (!options.device.empty() || !options.left_device.empty()) return open_devices(options, view_size);
  return open_files(options);
}

}  // namespace markservo::stereo_camera
