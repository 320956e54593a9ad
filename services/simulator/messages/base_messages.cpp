#include "services/simulator/messages/base_messages.hpp"

#include <markservo/RfidTagHits.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/WheelOdometry.hpp>
#include <utility>

namespace markservo::simulator {
namespace {

Pose2 pose_message(const geometry::PlanePose& pose) {
  Pose2 message{};
  message.x = pose.x;
  message.y = pose.y;
  message.heading = pose.heading;
  return message;
}

}  // namespace

WheelOdometry odometry_message(const OdometryReading& odometry) {
  WheelOdometry message{};
  message.utime = odometry.utime;
  message.left_ticks = odometry.ticks.left;
  message.right_ticks = odometry.ticks.right;
  message.left_distance = odometry.left_distance;
  message.right_distance = odometry.right_distance;
  return message;
}

RfidTagHits rfid_message(const TagRound& round) {
  RfidTagHits message{};
  message.utime = round.utime;
  message.window_start = round.window_start;
  message.window_end = round.window_end;
  message.window_known = round.window_known ? 1 : 0;
  for (const TagHit& hit : round.hits) {
    RfidTagHit hit_message{};
    hit_message.uid = hit.uid;
    hit_message.utime = hit.utime;
    hit_message.read_utime = hit.read_utime;
    hit_message.read_time_known = hit.read_time_known ? 1 : 0;
    hit_message.rssi = hit.rssi;
    hit_message.rssi_known = 1;
    message.hits.push_back(std::move(hit_message));
  }
  message.num_hits = static_cast<std::int32_t>(message.hits.size());
  return message;
}

SonarScan sonar_message(const SonarReading& scan) {
  SonarScan message{};
  message.utime = scan.utime;
  message.min_range = scan.min_range;
  message.max_range = scan.max_range;
  message.beam_width = scan.beam_width;
  for (const SonarEchoReading& echo : scan.echoes) {
    SonarEcho echo_message{};
    echo_message.pose = pose_message(echo.X_RS);
    echo_message.heard = echo.heard ? 1 : 0;
    echo_message.range = echo.range;
    message.echoes.push_back(echo_message);
  }
  message.num_echoes = static_cast<std::int32_t>(message.echoes.size());
  return message;
}

SimBaseTruth base_truth_message(const BaseTruth& truth, std::int64_t utime, std::int64_t odometry_seq) {
  SimBaseTruth message{};
  message.utime = utime;
  message.odometry_seq = odometry_seq;
  message.pose = pose_message(truth.pose);
  message.speed = truth.speed;
  message.turn_rate = truth.turn_rate;
  return message;
}

}  // namespace markservo::simulator
