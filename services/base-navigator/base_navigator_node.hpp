#pragma once

#include <chrono>
#include <markservo/channels.hpp>
#include <memory>
#include <optional>
#include <string>

#include "common/bus/service.hpp"
#include "common/motion/mover_watch.hpp"
#include "services/base-navigator/answer_pacing.hpp"
#include "services/base-navigator/navigator.hpp"

namespace markservo::base_navigator {

// BASE_GOAL, ROBOT_POSE, SONAR_SCAN, WHEEL_ODOMETRY and STOP_STATE in; BASE_STATUS and then BASE_COMMAND out, one of
// each per WHEEL_ODOMETRY. Without odometry nothing is sent, and the base's own watchdog stops it. When two claim to be
// the base, or to know where it is, STOP goes out until the base is latched.
class BaseNavigatorNode : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  void start(bus::Bus& bus) override;

 private:
  // Without the reason: it may hold numbers that change with every answer.
  struct Told {
    DriveState state = DriveState::kHold;
    std::string notice;
  };

  void on_stop(const StopState& stop);
  void on_goal(const BaseGoal& goal);
  void on_scan(const SonarScan& scan);
  void on_odometry(const WheelOdometry& odometry);
  void on_pose(const RobotPose& pose);
  motion::ReportHeard hear_report(const char* channel, const motion::Stamp& stamp);
  void begin_anew(const std::string& why);
  void after_input();
  void answer(const OdometryId& odometry);
  void watch_for_odometry();
  void tell(DriveState state, const std::string& reason);

  std::string stop_device_ = "base";
  NavigatorParameters parameters_;
  std::unique_ptr<Navigator> navigator_;
  NavigatorState state_;
  AnswerPacing pacing_;
  bus::Bus* bus_ = nullptr;
  std::optional<motion::MoverWatch> base_;
  std::optional<bus::Publisher<StopRequest>> stops_;
  std::optional<bus::Publisher<BaseCommand>> commands_;
  std::optional<bus::Publisher<BaseStatus>> statuses_;
  std::optional<Told> told_;
  std::optional<std::chrono::steady_clock::time_point> heard_odometry_;
};

}  // namespace markservo::base_navigator
