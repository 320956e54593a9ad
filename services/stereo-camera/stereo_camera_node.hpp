#pragma once

#include <cstdint>
#include <markservo/StereoFrame.hpp>
#include <optional>
#include <string>

#include "common/bus/service.hpp"
#include "services/stereo-camera/calibration/camera_geometry.hpp"
#include "services/stereo-camera/capture_record.hpp"
#include "services/stereo-camera/devices/background_reader.hpp"
#include "services/stereo-camera/frame_message.hpp"
#include "services/stereo-camera/stereo_camera_options.hpp"

namespace markservo::stereo_camera {

// Publishes STEREO_FRAME from cameras, videos or pictures.
//
// Pictures that cannot be used end the program at the start (exit code 2) and are dropped and counted later. A camera
// that goes away is opened again once a second; SERVICE_STATUS says waiting until then.
class StereoCameraNode : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  void check(const std::string& robot_file) override;
  bool reads_bus() const override { return false; }
  void start(bus::Bus& bus) override;
  void run(bus::Bus& bus) override;

  std::int64_t published() const { return record_.published(); }
  std::int64_t dropped() const { return record_.dropped(); }

 private:
  void read_first_pair();
  void choose_encoding(const bus::BusUrls& urls);
  void run_files(bus::Bus& bus);
  void run_cameras(bus::Bus& bus);
  void publish(const RawPair& pair, std::int64_t utime);
  void drop(const std::string& reason, std::int64_t count = 1);
  void tell_state(bus::Bus& bus);
  bool done() const { return options_.count > 0 && published() >= options_.count; }

  StereoCameraOptions options_;
  OpenedSource source_;
  CameraGeometry geometry_;
  std::optional<RawPair> first_;
  FrameMessage frame_;
  std::optional<bus::Publisher<StereoFrame>> publisher_;
  CaptureRecord record_;
};

}  // namespace markservo::stereo_camera
