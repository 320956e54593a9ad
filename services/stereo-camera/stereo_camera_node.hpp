#pragma once

#include <cstdint>
#include <markservo/StereoFrame.hpp>
#include <memory>
#include <optional>
#include <string>

#include "common/bus/options.hpp"
#include "common/bus/service.hpp"
#include "common/geometry/stereo_camera.hpp"
#include "services/stereo-camera/background_reader.hpp"
#include "services/stereo-camera/camera_geometry.hpp"
#include "services/stereo-camera/rectifier.hpp"
#include "services/stereo-camera/source_options.hpp"

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

  std::int64_t published() const { return published_; }
  std::int64_t dropped() const { return dropped_; }

 private:
  void add_source_options(const bus::Options& add);
  void add_geometry_options(const bus::Options& add);
  void prepare(const std::string& robot_file);
  void read_first_pair();
  void accept_size(cv::Size size);
  geometry::StereoCamera choose_cameras(cv::Size size);  // for pictures of `size`
  void tell_cameras();
  void choose_encoding(const bus::BusUrls& urls);
  void run_files(bus::Bus& bus);
  void run_cameras(bus::Bus& bus);
  void publish(const RawPair& pair, std::int64_t utime);
  void drop(const std::string& reason, std::int64_t count = 1);
  void tell_state(bus::Bus& bus);
  bool done() const { return count_ > 0 && published_ >= count_; }

  SourceOptions source_options_;
  GeometryOptions geometry_options_;
  std::string encoding_ = "auto";
  int jpeg_quality_ = 90;   // colours and gradients stay within the camera's noise, at an eighth of the raw size
  std::int64_t count_ = 0;  // pairs to publish; 0: no limit
  bool once_ = false;

  OpenedSource source_;
  CameraGeometry geometry_;
  std::optional<RawPair> first_;
  std::optional<cv::Size> size_;  // px, of every pair
  std::unique_ptr<Rectifier> rectifier_;
  std::string cameras_;  // which they are, to be told; empty before they are chosen
  std::optional<bus::Publisher<StereoFrame>> frames_;
  StereoFrame message_{};
  bool jpeg_ = false;

  std::int64_t published_ = 0;
  std::int64_t dropped_ = 0;
  std::int64_t dropped_told_ = 0;
  std::int64_t losses_ = 0;
  bool waiting_ = false;
  std::string last_reason_;
};

}  // namespace markservo::stereo_camera
