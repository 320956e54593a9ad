#include "tests/unit/rfid-localizer/drive.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "tests/experiments/localisation/heard_round.hpp"

namespace markservo::rfid_localizer::test {
namespace {

constexpr std::int64_t kSession = 5;

LocalizerParameters with_survey(LocalizerParameters parameters, const robot::RobotDescription& robot) {
  parameters.survey_sigma = robot.floor_tags->survey_sigma;
  return parameters;
}

}  // namespace

robot::RobotDescription the_robot() {
  static const robot::RobotDescription robot =
      robot::load_robot_description(std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml");
  return robot;
}

double Scored::error() const {
  return std::hypot(estimate.pose.pose[0] - truth.pose.x, estimate.pose.pose[1] - truth.pose.y);
}

double Scored::heading_error() const {
  return std::abs(geometry::wrapped(estimate.pose.pose[2] - truth.pose.heading));
}

double Scored::sigma() const {
  const Eigen::Matrix2d position = estimate.pose.covariance.topLeftCorner<2, 2>();
  return std::sqrt(position.selfadjointView<Eigen::Lower>().eigenvalues().maxCoeff());
}

double Scored::nees() const {
  const Eigen::Vector3d d(estimate.pose.pose[0] - truth.pose.x, estimate.pose.pose[1] - truth.pose.y,
                          geometry::wrapped(estimate.pose.pose[2] - truth.pose.heading));
  return d.dot(estimate.pose.covariance.inverse() * d);
}

Drive::Drive(const DriveSettings& settings)
    : settings_(settings),
      rig_(std::make_unique<simulator::BaseRig>(settings.robot, settings.rig, settings.start, settings.seed, kEpoch)),
      localizer_(*settings.robot.base, *settings.robot.rfid, settings.robot.floor_tags->field(settings.rig.tag_field),
                 with_survey(settings.localizer, settings.robot)),
      encoders_(settings.encoders) {}

void Drive::go(double time, double speed, double turn_rate) {
  const std::int64_t end = rig_->utime() + std::llround(1e6 * time);
  for (int step = 0; rig_->utime() < end; ++step) {
    constexpr int kRepeat = 50;  // steps: commands every 0.1 s
    if (step % kRepeat == 0) rig_->command(speed, turn_rate);
    rig_->step();
    hear(rig_->take_due());
  }
}

void Drive::carry_to(const geometry::PlanePose& pose) {
  left_before_ = last_ticks_.left;
  right_before_ = last_ticks_.right;
  const std::int64_t utime = rig_->utime();
  rig_ = std::make_unique<simulator::BaseRig>(settings_.robot, settings_.rig, pose, settings_.seed + 1000 * ++rigs_,
                                              utime);
  const auto first = rig_->take_due();
  left_before_ -= first.odometry->ticks.left;
  right_before_ -= first.odometry->ticks.right;
}

void Drive::change_reader(const simulator::RfidReaderParameters& parameters) {
  settings_.rig.reader = parameters;
  rig_->change_reader(parameters);
}

void Drive::hear(const simulator::BaseOutputs& due) {
  if (reader_) {
    for (const simulator::TagRound& round : due.rounds) {
      TagRound told = experiments::heard(round, kSession);
      tamper(told);
      localizer_.observe(told);
      if (!localizer_.has_wheels()) history_.push_back(now());
    }
  }
  if (due.odometry) {
    last_ticks_ = {due.odometry->ticks.left + left_before_, due.odometry->ticks.right + right_before_};
    if (!encoders_) return;
    localizer_.observe(EncoderReading{due.odometry->utime, kSession, last_ticks_.left, last_ticks_.right});
    history_.push_back(now());
  }
}

Scored Drive::now() const {
  return {time(), localizer_.estimate(rig_->utime()), rig_->truth()};
}

std::vector<Scored> Drive::since(double time) const {
  std::vector<Scored> scores;
  for (const Scored& one : history_) {
    if (one.time >= time) scores.push_back(one);
  }
  return scores;
}

double mean_error(const std::vector<Scored>& scores) {
  double sum = 0.0;
  for (const Scored& one : scores) sum += one.error();
  return sum / static_cast<double>(scores.size());
}

double worst_error(const std::vector<Scored>& scores) {
  double worst = 0.0;
  for (const Scored& one : scores) worst = std::max(worst, one.error());
  return worst;
}

double longest_untruth(const std::vector<Scored>& scores, double sigmas) {
  double longest = 0.0;
  double begin = -1.0;
  for (const Scored& one : scores) {
    const bool untrue = one.localised() && one.error() > sigmas * one.sigma();
    if (!untrue) {
      begin = -1.0;
      continue;
    }
    if (begin < 0.0) begin = one.time;
    longest = std::max(longest, one.time - begin);
  }
  return longest;
}

}  // namespace markservo::rfid_localizer::test
