#pragma once

#include <chrono>
#include <markservo/BaseCommand.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/WheelOdometry.hpp>
#include <memory>
#include <optional>
#include <string>

#include "common/bus/service.hpp"
#include "services/base-navigator/answer_pacing.hpp"
#include "services/base-navigator/navigator.hpp"

namespace markservo::base_navigator {

// BASE_GOAL, ROBOT_POSE, SONAR_SCAN, WHEEL_ODOMETRY and STOP_STATE in; BASE_STATUS and then BASE_COMMAND out, one of
// each per WHEEL_ODOMETRY. Without odometry nothing is sent, and the base's own watchdog stops it.
class BaseNavigatorNode : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  void start(bus::Bus& bus) override;

 private:
  void add_motion_options(CLI::App& app);
  void handle(const WheelOdometry& odometry);
  void handle(const RobotPose& pose);
  void answer(const OdometryId& odometry);
  void watch_for_odometry();
  void tell(DriveState state, const std::string& reason);

  std::string stop_device_ = "base";
  NavigatorParameters parameters_;
  std::unique_ptr<Navigator> navigator_;
  NavigatorState state_;
  AnswerPacing pacing_;
  std::optional<OdometryId> pose_;
  bus::Bus* bus_ = nullptr;
  std::optional<bus::Publisher<BaseCommand>> commands_;
  std::optional<bus::Publisher<BaseStatus>> statuses_;
  std::optional<DriveState> told_;
  std::optional<std::chrono::steady_clock::time_point> heard_odometry_;
};

}  // namespace markservo::base_navigator
