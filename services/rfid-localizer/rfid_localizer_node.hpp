#pragma once

#include <cstdint>
#include <markservo/channels.hpp>
#include <memory>
#include <optional>
#include <string>

#include "common/bus/repeat_timer.hpp"
#include "common/bus/service.hpp"
#include "common/motion/device_trust.hpp"
#include "common/motion/sole_writer.hpp"
#include "services/rfid-localizer/localizer.hpp"
#include "services/rfid-localizer/localizer_options.hpp"
#include "services/rfid-localizer/wheel_report.hpp"

namespace markservo::rfid_localizer {

// RFID_TAG_HITS and WHEEL_ODOMETRY in, ROBOT_POSE out: one per WHEEL_ODOMETRY, or, while there is none, one per
// RFID_TAG_HITS. Wheels count only from the session of the base's own STOP_STATE, rounds from one writer at a time.
class RfidLocalizerNode : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  void start(bus::Bus& bus) override;

 private:
  void begin();
  void publish(std::int64_t utime, std::int64_t odometry_session, std::int64_t odometry_seq);
  void tell(const RobotPose& pose);

  LocalizerOptions options_;
  robot::RobotDescription robot_;
  LocalizerParameters parameters_;
  std::unique_ptr<Localizer> localizer_;
  std::optional<motion::DeviceTrust> base_;
  motion::SoleWriter rounds_{"RFID_TAG_HITS"};
  bus::Bus* bus_ = nullptr;
  std::optional<bus::Publisher<RobotPose>> poses_;
  std::string told_;
  WheelReport wheel_report_;
  bus::RepeatTimer tell_timer_{1'000'000};
};

}  // namespace markservo::rfid_localizer
