#include "services/rfid-localizer/localizer_messages.hpp"

#include <fmt/core.h>

#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/WheelOdometry.hpp>

#include "common/time/seconds_between.hpp"

namespace markservo::rfid_localizer {
namespace {

PaperLocalisation paper_message(const std::optional<PaperEstimate>& estimate) {
  PaperLocalisation message{};
  if (!estimate) return message;
  message.measured_known = 1;
  message.utime = estimate->utime;
  message.measured_x = estimate->measured.x();
  message.measured_y = estimate->measured.y();
  message.direction_known = estimate->direction ? 1 : 0;
  message.direction = estimate->direction.value_or(0.0);
  message.speed = estimate->speed;
  message.delay = estimate->delay;
  message.compensated_x = estimate->compensated.x();
  message.compensated_y = estimate->compensated.y();
  return message;
}

// The paper gives no error of its own: its measured one stands in (2.6 cm at rest, 10 degrees of a Hough direction).
void take_paper_pose(const PaperLocalisation& paper, RobotPose& message) {
  constexpr double kPosition = 0.026;    // m
  constexpr double kDirection = 0.1745;  // rad
  constexpr double kOld = 2.0;           // s, after which the reads tell nothing of now
  message.odometry_used = 0;
  if (paper.measured_known == 0) {
    message.state = RobotPose::SEARCHING;
    message.reason = "no tag of the map was read yet";
    return;
  }
  const double age = seconds_between(paper.utime, message.utime);
  message.state = age <= kOld ? RobotPose::LOCALISED : RobotPose::LOST;
  message.reason.clear();
  if (age > kOld) message.reason = fmt::format("no tag of the map was read for {:.1f} s", age);
  message.pose = {paper.compensated_x, paper.compensated_y, paper.direction};
  message.speed = paper.speed;
  message.turn_rate = 0.0;
  message.covariance = {kPosition * kPosition, 0.0, 0.0,
                        kPosition * kPosition, 0.0, paper.direction_known != 0 ? kDirection * kDirection : kAnyHeading};
}

}  // namespace

EncoderReading encoder_reading(const WheelOdometry& message) {
  return {message.utime, message.session, message.left_ticks, message.right_ticks};
}

TagRound tag_round(const RfidTagHits& message) {
  TagRound round{message.utime,      message.session,           message.window_start,
                 message.window_end, message.window_known != 0, {}};
  for (const RfidTagHit& hit : message.hits) {
    round.reads.push_back({hit.uid, {}});
    if (hit.read_time_known != 0) round.reads.back().read_utime = hit.read_utime;
  }
  return round;
}

RobotPose pose_message(const Estimate& estimate, std::int64_t utime, bool paper_pose) {
  RobotPose message{};
  message.utime = utime;
  switch (estimate.placement) {
    case Placement::kSearching:
      message.state = RobotPose::SEARCHING;
      break;
    case Placement::kLocalised:
      message.state = RobotPose::LOCALISED;
      break;
    case Placement::kLost:
      message.state = RobotPose::LOST;
      break;
  }
  const auto& pose = estimate.pose.pose;
  message.pose = {pose[0], pose[1], pose[2]};
  const auto& P = estimate.pose.covariance;
  message.covariance = {P(0, 0), P(0, 1), P(0, 2), P(1, 1), P(1, 2), P(2, 2)};
  message.speed = estimate.pose.speed;
  message.turn_rate = estimate.pose.turn_rate;
  message.odometry_used = estimate.odometry_used ? 1 : 0;
  message.delay = estimate.delay.mean;
  message.delay_sigma = estimate.delay.sigma;
  message.paper = paper_message(estimate.paper);
  message.reason = estimate.reason;
  if (paper_pose) take_paper_pose(message.paper, message);
  return message;
}

}  // namespace markservo::rfid_localizer
