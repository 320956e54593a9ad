#include "services/stereo-camera/stereo_camera_node.hpp"

#include <algorithm>
#include <chrono>
#include <opencv2/core/utils/logger.hpp>
#include <utility>

#include "common/bus/log_not_written.hpp"
#include "common/bus/network_check.hpp"
#include "common/logging/log.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/time/clocks.hpp"
#include "services/stereo-camera/files/schedule.hpp"

namespace markservo::stereo_camera {
namespace {

using std::chrono::microseconds;
using std::chrono::milliseconds;

constexpr milliseconds kPollSlice{50};      // longest wait between two looks at the bus
constexpr milliseconds kStatePeriod{1000};  // drops are told in one line per period
constexpr int kFirstPairAttempts = 30;      // cameras may begin with damaged or unpaired frames

void tell(const ChosenCameras& cameras) {
  for (const std::string& warning : cameras.warnings) logging::warn("{}", warning);
  logging::info("{}", cameras.summary);
}

}  // namespace

void StereoCameraNode::add_options(CLI::App& app) {
  add_stereo_camera_options(app, options_);
}

void StereoCameraNode::configure(const std::string& robot_file) {
  prepare(robot_file);
  read_first_pair();
}

// Devices are opened by the first read.
void StereoCameraNode::check(const std::string& robot_file) {
  prepare(robot_file);
  if (geometry_.size) tell(choose_cameras(geometry_, *geometry_.size));
}

void StereoCameraNode::prepare(const std::string& robot_file) {
  // What OpenCV has to say goes into our own messages.
  cv::utils::logging::setLogLevel(cv::utils::logging::LOG_LEVEL_SILENT);
  if (options_.once) options_.count = 1;
  geometry_ = choose_geometry(options_.geometry, robot_file);
  source_ = open_source(options_.source, geometry_.size.value_or(cv::Size(640, 480)));
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
  if (result.status == ReadStatus::kWaiting && options_.source.wait_for_device) {
    logging::warn("{}; waiting for it", result.reason);
    if (geometry_.size) choose_cameras(geometry_, *geometry_.size);  // refused now, not when the camera is there
    return;
  }
  if (result.status != ReadStatus::kPair) {
    throw ConfigurationError(result.reason.empty() ? "the source holds no pictures; allowed: one pair or more"
                                                   : result.reason);
  }
  if (!result.reason.empty()) logging::warn("{}", result.reason);
  const std::string complaint = pair_complaint(result.pair.left, result.pair.right, cv::Size());
  if (!complaint.empty()) throw ConfigurationError("first pair: " + complaint);
  frame_.begin(geometry_, result.pair.left.size());
  first_ = std::move(result.pair);
}

void StereoCameraNode::choose_encoding(const bus::BusUrls& urls) {
  const std::string obstacle = options_.encoding == "auto" ? bus::raw_frames_obstacle(urls.out) : std::string();
  if (!obstacle.empty()) logging::warn("{}", bus::jpeg_notice(obstacle));
  if (options_.encoding == "jpeg" || !obstacle.empty()) {
    frame_.encode_jpeg_pictures(options_.jpeg_quality);
  } else {
    frame_.encode_raw_pictures();
  }
}

void StereoCameraNode::start(bus::Bus& bus) {
  if (options_.source.loop && options_.count == 0 && bus::is_file(bus.urls().out)) {
    throw ConfigurationError("--loop is given and the bus is a log, which would never end; allowed: with --count");
  }
  choose_encoding(bus.urls());
  publisher_ = bus.advertise(channels::kStereoFrame);
}

void StereoCameraNode::run(bus::Bus& bus) {
  if (frame_.size()) tell(frame_.cameras());
  bus.every(kStatePeriod, [this, &bus] { tell_state(bus); });
  if (source_.live) {
    run_cameras(bus);
  } else {
    run_files(bus);
  }
  logging::info("published {} pairs, dropped {}", record_.published(), record_.dropped());
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
    record_.wait(true, "no camera yet");
    bus.set_state("waiting", "no camera yet");
  }
  BackgroundReader reader(std::move(source_.source));
  while (!done() && bus.poll(milliseconds(0))) {
    BackgroundReader::News news = reader.take(kPollSlice);
    if (news.dropped > 0) drop(news.reason, news.dropped);
    if (news.skipped > 0) drop("a newer pair came before it was published", news.skipped);
    record_.lose(news.losses);
    if (record_.wait(news.waiting, news.reason)) {
      if (news.waiting) {
        logging::warn("{}; trying again once a second", news.reason);
      } else {
        logging::info("cameras are there");
      }
      tell_state(bus);
    }
    if (!news.pair) continue;
    if (!frame_.size()) {
      const std::string complaint = pair_complaint(news.pair->left, news.pair->right, cv::Size());
      if (!complaint.empty()) {
        drop(complaint);
        continue;
      }
      try {
        frame_.begin(geometry_, news.pair->left.size());
        tell(frame_.cameras());
      } catch (const ConfigurationError& error) {
        drop(error.what());
        continue;
      }
    }
    publish(*news.pair, news.pair->exposure_utime.value_or(wall_clock_us()));
  }
}

void StereoCameraNode::publish(const RawPair& pair, std::int64_t utime) {
  const std::string complaint = pair_complaint(pair.left, pair.right, *frame_.size());
  if (!complaint.empty()) {
    drop("pair " + std::to_string(pair.index) + ": " + complaint);
    return;
  }
  StereoFrame& frame = frame_.of(pair, utime);
  try {
    publisher_->publish(frame);
    record_.publish();
  } catch (const bus::LogNotWritten&) {
    throw;  // no pair's fault
  } catch (const std::exception& error) {
    drop(error.what());
  }
}

void StereoCameraNode::drop(const std::string& reason, std::int64_t count) {
  record_.drop(reason, count);
  logging::debug("dropped: {}", reason);
}

void StereoCameraNode::tell_state(bus::Bus& bus) {
  const CaptureRecord::Health health = record_.next_health();
  if (health.state == "ready" && !health.reason.empty()) logging::warn("{}", health.reason);
  bus.set_state(health.state, health.reason);
}

}  // namespace markservo::stereo_camera
