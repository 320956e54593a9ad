#include "services/stereo-camera/source_options.hpp"

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "common/robot/configuration_error.hpp"
#include "services/stereo-camera/devices/device_source.hpp"
#include "services/stereo-camera/files/file_source.hpp"
#include "services/stereo-camera/files/picture_list.hpp"
#include "services/stereo-camera/files/picture_stream.hpp"
#include "services/stereo-camera/files/video_stream.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr double kMaxRate_hz = 1000.0;
constexpr double kRateTolerance = 0.001;  // 29.97 and 30 frames a second drift apart by a frame in 33 s

constexpr const char* kWays =
    "exactly one of: --left-device and --right-device; --device with --side-by-side; --left and --right; --input with "
    "--side-by-side";

std::vector<std::string> paths_of(const std::vector<NumberedPicture>& pictures) {
  std::vector<std::string> paths;
  paths.reserve(pictures.size());
  for (const NumberedPicture& picture : pictures) paths.push_back(picture.path);
  return paths;
}

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
  if (options.rate_hz && !(*options.rate_hz > 0.0 && *options.rate_hz <= kMaxRate_hz)) {
    throw ConfigurationError("--rate is " + std::to_string(*options.rate_hz) + " Hz; allowed: above 0 and up to 1000");
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

std::unique_ptr<FileSource> open_videos(const SourceOptions& options) {
  auto left = std::make_unique<VideoStream>(options.left, "--left");
  auto right = std::make_unique<VideoStream>(options.right, "--right");
  if (!options.rate_hz && std::abs(left->rate() - right->rate()) > kRateTolerance * left->rate()) {
    throw ConfigurationError("--left has " + std::to_string(left->rate()) + " frames a second, --right " +
                             std::to_string(right->rate()) + "; allowed: the same rate (or state it with --rate)");
  }
  return std::make_unique<FileSource>(std::move(left), std::move(right), options.loop);
}

OpenedSource open_files(const SourceOptions& options) {
  OpenedSource opened;
  std::unique_ptr<FileSource> source;
  if (options.side_by_side) {
    std::unique_ptr<ImageStream> both;
    if (is_picture_name(options.input)) {
      both = std::make_unique<PictureStream>(paths_of(expand_pattern(options.input, "--input")));
    } else {
      both = std::make_unique<VideoStream>(options.input, "--input");
    }
    source = std::make_unique<FileSource>(std::move(both), options.loop);
  } else if (is_picture_name(options.left) && is_picture_name(options.right)) {
    const auto left = expand_pattern(options.left, "--left");
    PairedPictures pairs = pair_by_number(left, expand_pattern(options.right, "--right"));
    opened.note = pairs.note;
    source = std::make_unique<FileSource>(std::make_unique<PictureStream>(std::move(pairs.left)),
                                          std::make_unique<PictureStream>(std::move(pairs.right)), options.loop);
  } else if (is_picture_name(options.left) != is_picture_name(options.right)) {
    throw ConfigurationError("--left is '" + options.left + "' and --right is '" + options.right +
                             "'; allowed: pictures on both sides or videos on both sides");
  } else {
    source = open_videos(options);
  }
  const double stated = source->rate() > 0.0 ? source->rate() : kDefaultFileRate_hz;
  opened.rate_hz = options.rate_hz.value_or(stated);
  opened.source = std::move(source);
  return opened;
}

}  // namespace

OpenedSource open_source(const SourceOptions& options, cv::Size view_size) {
  check_way(options);
  if (!options.device.empty() || !options.left_device.empty()) return open_devices(options, view_size);
  return open_files(options);
}

}  // namespace markservo::stereo_camera
