#include "services/stereo-camera/stereo_camera_node.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <opencv2/core/utils/logger.hpp>
#include <utility>

#include "common/bus/network_check.hpp"
#include "common/bus/options.hpp"
#include "common/logging/log.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/time/clocks.hpp"
#include "services/stereo-camera/encoder.hpp"
#include "services/stereo-camera/schedule.hpp"

namespace markservo::stereo_camera {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr milliseconds kPollSlice{50};      // longest wait between two looks at the bus
constexpr milliseconds kStatePeriod{1000};  // drops are told in one line per period
constexpr int kFirstPairAttempts = 30;      // cameras may begin with damaged or unpaired frames

}  // namespace

void StereoCameraNode::add_options(CLI::App& app) {
  const bus::Options add(app);
  add_source_options(add);
  add_geometry_options(add);
  add.option("--encoding", encoding_, "raw, jpeg, or auto: raw where the network's buffers hold it")
      .one_of({"auto", "raw", "jpeg"})
      .show_default();
  add.option("--jpeg-quality", jpeg_quality_, "1 to 100").in_range(1, 100).show_default();
  add.option("--count", count_, "Stop after this many pairs; 0: no limit").not_negative().show_default();
  add.flag("--once", once_, "Stop after one pair");
}

void StereoCameraNode::add_source_options(const bus::Options& add) {
  SourceOptions& source = source_options_;
  add.option("--left-device", source.left_device, "Left camera, for example /dev/video0");
  add.option("--right-device", source.right_device, "Right camera, for example /dev/video2");
  add.option("--device", source.device, "One camera that delivers both views (with --side-by-side)");
  add.option("--left", source.left, "Left video, picture, or pattern as left_%02d.png");
  add.option("--right", source.right, "Right video, picture, or pattern");
  add.option("--input", source.input, "One video, picture or pattern with both views (with --side-by-side)");
  add.flag("--side-by-side", source.side_by_side, "Both views in one picture, the left view in the left half");
  add.flag("--loop", source.loop, "Begin files again at their end");
  add.option("--rate", source.rate_hz,
             "Pairs per second, Hz; default: videos by the times they state, pictures 10, cameras 30");
  add.option("--offset-s", source.offset_s,
             "What the right video's time is more than the left's at the same moment, s; default: 0");
  add.flag("--estimate-offset", source.estimate_offset, "Find the offset by what moves in both videos' first minute");
  add.flag("--wait-for-device", source.wait_for_device, "Wait for a camera that is not there at the start");
  add.option("--width", source.width, "Width asked of a camera's view, px; default: as calibrated").in_range(0, 16384);
  add.option("--height", source.height, "Height asked of a camera's view, px; default: as calibrated")
      .in_range(0, 16384);
  add.option("--exposure", source.camera.exposure, "Fixed exposure in the driver's unit; default: automatic");
  add.option("--white-balance", source.camera.white_balance_K, "Fixed white balance, K; default: held as it is");
  add.flag("--auto-white-balance", source.camera.auto_white_balance, "Let cameras balance white by themselves");
}

void StereoCameraNode::add_geometry_options(const bus::Options& add) {
  GeometryOptions& geometry = geometry_options_;
  add.option("--calibration", geometry.calibration,
             "Stereo calibration to rectify by: one file of OpenCV (K1 D1 K2 D2 R T; YAML, XML or JSON), or two of "
             "ROS's camera_info, the left camera's first");
  add.option("--intrinsics", geometry.intrinsics, "M1 D1 M2 D2 as OpenCV's stereo_calib sample writes them");
  add.option("--extrinsics", geometry.extrinsics, "R T R1 R2 P1 P2 as that sample writes them");
  add.option("--board-square", geometry.board_square,
             "Edge of the calibration board's squares, m, where T counts in squares or the file has a square_size");
  add.option("--metres-per-unit", geometry.metres_per_unit,
             "Unit of the calibration's T, m: 0.001 for a board given in mm, 0.01 in cm, 0.0254 in inches; default: 1");
  add.option(
         "--lens", geometry.lens,
         "Model of the calibration's distortion: pinhole, fisheye (that of cv::fisheye), or auto: as the file says, "
         "else pinhole")
      .one_of({"auto", "pinhole", "fisheye"})
      .show_default();
  add.flag("--accept-rms", geometry.accept_any_error,
           "Take a calibration with an error above 0.5 px, or with none stated");
  add.option("--fx", geometry.fx, "Focal length of rectified pictures, px; replaces robot.yaml's cameras");
  add.option("--fy", geometry.fy, "Focal length along v, px; default: --fx");
  add.option("--cx-left", geometry.cx_left, "Principal column on the left, px; default: the middle");
  add.option("--cx-right", geometry.cx_right, "Principal column on the right, px; default: the middle");
  add.option("--cy", geometry.cy, "Principal row, px; default: the middle");
  add.option("--baseline", geometry.baseline, "Right lens minus left lens, m");
}

void StereoCameraNode::configure(const std::string& robot_file) {
  prepare(robot_file);
  read_first_pair();
}

// Devices are opened by the first read.
void StereoCameraNode::check(const std::string& robot_file) {
  prepare(robot_file);
  if (geometry_.size) choose_cameras(*geometry_.size);
  tell_cameras();
}

void StereoCameraNode::prepare(const std::string& robot_file) {
  // What OpenCV has to say goes into our own messages.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  if (once_) count_ = 1;
  geometry_ = choose_geometry(geometry_options_, robot_file);
  source_ = open_source(source_options_, geometry_.size.value_or(cv::Size(640, 480)));
  for (const std::string& warning : source_.warnings) logging::warn("{}", warning);
  if (!source_.note.empty()) logging::info("{}", source_.note);
}

void StereoCameraNode::read_first_pair() {
  ReadResult result;
  for (int attempt = 0; attempt < kFirstPairAttempts; ++attempt) {
    result = source_.source->read();
    const bool camera_begins = source_.live && result.status == ReadStatus::kDropped;
    if (!camera_begins) break;
  }
  if (result.status == ReadStatus::kWaiting && source_options_.wait_for_device) {
    logging::warn("{}; waiting for it", result.reason);
    if (geometry_.size) choose_cameras(*geometry_.size);
    return;
  }
  if (result.status != ReadStatus::kPair) {
    throw ConfigurationError(result.reason.empty() ? "the source holds no pictures; allowed: one pair or more"
                                                   : result.reason);
  }
  if (!result.reason.empty()) logging::warn("{}", result.reason);
  const std::string complaint = pair_complaint(result.pair.left, result.pair.right, cv::Size());
  if (!complaint.empty()) throw ConfigurationError("first pair: " + complaint);
  accept_size(result.pair.left.size());
  first_ = std::move(result.pair);
}

void StereoCameraNode::accept_size(cv::Size size) {
  if (geometry_.size && size != *geometry_.size) {
    throw ConfigurationError("pictures are " + size_text(size) + "; allowed: " + size_text(*geometry_.size) +
                             " as in " + geometry_.size_source +
                             (geometry_.calibration ? "" : " (or --calibration, or --fx and --baseline)"));
  }
  const geometry::StereoCamera camera = choose_cameras(size);
  message_.calibration.fx = camera.fx;
  message_.calibration.fy = camera.fy;
  message_.calibration.cx_left = camera.cx_left;
  message_.calibration.cx_right = camera.cx_right;
  message_.calibration.cy = camera.cy;
  message_.calibration.baseline = camera.baseline;
  message_.width = size.width;
  message_.height = size.height;
  size_ = size;
}

geometry::StereoCamera StereoCameraNode::choose_cameras(cv::Size size) {
  geometry_.rectify_for(size);
  const geometry::StereoCamera camera = geometry_.camera(size);
  cameras_ = fmt::format("cameras: f {:.1f} px, baseline {:.4f} m; ", camera.fx, camera.baseline);
  if (!geometry_.calibration) {
    cameras_ += "pictures are taken as rectified";
    return camera;
  }
  rectifier_ = std::make_unique<Rectifier>(*geometry_.calibration, size);
  const SharedView& view = rectifier_->shared_view();
  cameras_ += fmt::format("{:.0f}% of the rectified pictures show something, {:.0f}% of the cameras' pictures are left",
                          100.0 * view.filled, 100.0 * view.kept);
  return camera;
}

void StereoCameraNode::tell_cameras() {
  if (cameras_.empty()) return;
  if (geometry_.calibration) {
    for (const std::string& warning : geometry_.calibration->warnings) logging::warn("{}", warning);
  }
  logging::info("{}", cameras_);
}

void StereoCameraNode::choose_encoding(const bus::BusUrls& urls) {
  jpeg_ = encoding_ == "jpeg";
  if (encoding_ == "auto" && !bus::raw_frames_fit(urls.out)) {
    jpeg_ = true;
    logging::warn("{}", bus::raw_frames_advice());
  }
  message_.encoding = jpeg_ ? StereoFrame::ENCODING_JPEG : StereoFrame::ENCODING_BGR8;
}

void StereoCameraNode::start(bus::Bus& bus) {
  if (source_options_.loop && count_ == 0 && bus::is_file(bus.urls().out)) {
    throw ConfigurationError("--loop is given and the bus is a log, which would never end; allowed: with --count");
  }
  choose_encoding(bus.urls());
  frames_ = bus.advertise(channels::kStereoFrame);
}

void StereoCameraNode::run(bus::Bus& bus) {
  if (size_) tell_cameras();
  bus.every(kStatePeriod, [this, &bus] { tell_state(bus); });
  if (source_.live) {
    run_cameras(bus);
  } else {
    run_files(bus);
  }
  logging::info("published {} pairs, dropped {}", published_, dropped_);
}

void StereoCameraNode::run_files(bus::Bus& bus) {
  const bool paced = !bus::is_file(bus.urls().out);
  const std::int64_t start_us = wall_clock_us();
  const auto steady_start = std::chrono::steady_clock::now();
  // The steady clock paces, so that a step of the wall clock neither stalls nor hurries the pictures.
  const auto now_us = [&] {
    return std::chrono::duration_cast<microseconds>(std::chrono::steady_clock::now() - steady_start).count();
  };
  Schedule schedule(0, first_ ? first_->time_us : 0, source_.period_us);
  while (!done() && bus.poll(milliseconds(0))) {
    ReadResult result{ReadStatus::kPair, {}, ""};
    if (first_) {
      result.pair = std::move(*std::exchange(first_, std::nullopt));
    } else {
      result = source_.source->read();
    }
    if (result.status == ReadStatus::kEnd) {
      if (!result.reason.empty()) logging::warn("{}", result.reason);
      return;
    }
    if (result.status == ReadStatus::kDropped) {
      drop(result.reason);
      continue;
    }
    if (!result.reason.empty()) logging::warn("{}", result.reason);
    if (!paced) {
      publish(result.pair, kLogEpoch_us + result.pair.time_us);
      continue;
    }
    const std::int64_t due_us = schedule.due(result.pair.time_us, now_us());
    while (now_us() < due_us) {
      const auto left = std::chrono::ceil<milliseconds>(microseconds(due_us - now_us()));
      if (!bus.poll(std::min(left, kPollSlice))) return;
    }
    publish(result.pair, start_us + due_us);
  }
}

void StereoCameraNode::run_cameras(bus::Bus& bus) {
  if (first_) {
    publish(*first_, first_->exposure_utime.value_or(wall_clock_us()));
    first_.reset();
  } else {
    waiting_ = true;
    last_reason_ = "no camera yet";
    bus.set_state("waiting", last_reason_);
  }
  BackgroundReader reader(std::move(source_.source));
  while (!done() && bus.poll(milliseconds(0))) {
    BackgroundReader::News news = reader.take(kPollSlice);
    if (news.dropped > 0) drop(news.reason, news.dropped);
    if (news.skipped > 0) drop("a newer pair came before it was published", news.skipped);
    losses_ += news.losses;
    if (news.waiting && !news.reason.empty()) last_reason_ = news.reason;
    if (news.waiting != waiting_) {
      waiting_ = news.waiting;
      if (waiting_) {
        logging::warn("{}; trying again once a second", news.reason);
      } else {
        logging::info("cameras are there");
      }
      tell_state(bus);
    }
    if (!news.pair) continue;
    if (!size_) {
      const std::string complaint = pair_complaint(news.pair->left, news.pair->right, cv::Size());
      if (!complaint.empty()) {
        drop(complaint);
        continue;
      }
      try {
        accept_size(news.pair->left.size());
        tell_cameras();
      } catch (const ConfigurationError& error) {
        drop(error.what());
        continue;
      }
    }
    publish(*news.pair, news.pair->exposure_utime.value_or(wall_clock_us()));
  }
}

void StereoCameraNode::publish(const RawPair& pair, std::int64_t utime) {
  const std::string complaint = pair_complaint(pair.left, pair.right, *size_);
  if (!complaint.empty()) {
    drop("pair " + std::to_string(pair.index) + ": " + complaint);
    return;
  }
  cv::Mat left = pair.left;
  cv::Mat right = pair.right;
  if (rectifier_) {
    cv::Mat left_rectified;
    cv::Mat right_rectified;
    rectifier_->rectify(left, right, left_rectified, right_rectified);
    left = left_rectified;
    right = right_rectified;
  }
  if (jpeg_) {
    encode_jpeg(left, jpeg_quality_, message_.left);
    encode_jpeg(right, jpeg_quality_, message_.right);
  } else {
    encode_raw(left, message_.left);
    encode_raw(right, message_.right);
  }
  message_.left_size = static_cast<std::int32_t>(message_.left.size());
  message_.right_size = static_cast<std::int32_t>(message_.right.size());
  message_.utime = utime;
  try {
    frames_->publish(message_);
    ++published_;
  } catch (const std::exception& error) {
    drop(error.what());
  }
}

void StereoCameraNode::drop(const std::string& reason, std::int64_t count) {
  dropped_ += count;
  last_reason_ = reason;
  logging::debug("dropped: {}", reason);
}

void StereoCameraNode::tell_state(bus::Bus& bus) {
  const std::int64_t newly_dropped = dropped_ - std::exchange(dropped_told_, dropped_);
  if (waiting_) {
    bus.set_state("waiting", last_reason_ + " (lost " + std::to_string(losses_) + " times)");
  } else if (newly_dropped > 0) {
    const std::string told = std::to_string(newly_dropped) + " pairs dropped in the last second, " +
                             std::to_string(dropped_) + " since the start; last: " + last_reason_;
    logging::warn("{}", told);
    bus.set_state("ready", told);
  } else {
    bus.set_state("ready");
  }
}

}  // namespace markservo::stereo_camera
