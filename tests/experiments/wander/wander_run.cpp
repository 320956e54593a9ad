#include "tests/experiments/wander/wander_run.hpp"

#include <cmath>
#include <vector>

#include "services/rfid-localizer/localizer.hpp"
#include "services/rfid-localizer/robot_parameters.hpp"
#include "tests/experiments/localisation/described_reader.hpp"
#include "tests/experiments/localisation/described_wheels.hpp"
#include "tests/experiments/localisation/field_box.hpp"
#include "tests/experiments/localisation/fisher_bound.hpp"
#include "tests/experiments/localisation/gaussian_radius.hpp"
#include "tests/experiments/localisation/heard_round.hpp"
#include "tests/experiments/localisation/live_score.hpp"
#include "tests/experiments/statistics.hpp"

namespace markservo::experiments {
namespace {

namespace localizer = rfid_localizer;

constexpr std::int64_t kSession = 1;

PoseEstimate estimate_at(const localizer::Localizer& localizer, std::int64_t utime) {
  const localizer::Estimate now = localizer.estimate(utime);
  PoseEstimate result;
  result.time = seconds(utime);
  result.p_WR = now.pose.pose.head<2>();
  result.heading = now.pose.pose[2];
  result.covariance = now.pose.covariance;
  result.speed = now.pose.speed;
  result.turn_rate = now.pose.turn_rate;
  result.localised = now.placement == localizer::Placement::kLocalised;
  return result;
}

std::vector<double> times_after(const Drive& drive, double settling) {
  std::vector<double> times;
  for (const PathPoint& point : drive.truth) {
    if (point.time >= settling) times.push_back(point.time);
  }
  return times;
}

}  // namespace

WanderScore localise_in_process(const Drive& drive, const robot::RobotDescription& robot, const WanderRun& run) {
  localizer::LocalizerParameters parameters = localizer::parameters_of(robot);
  if (!run.judging) parameters.judge.reset();
  localizer::Localizer localizer(*robot.base, *robot.rfid, robot.floor_tags->field(run.tag_field), parameters);
  WanderScore score;
  std::vector<PoseEstimate> estimates;
  bool was_lost = false;
  std::size_t next_round = 0;
  for (const simulator::OdometryReading& odometry : drive.odometry) {
    for (; next_round < drive.rounds.size() && drive.rounds[next_round].utime <= odometry.utime; ++next_round) {
      localizer.observe(heard(drive.rounds[next_round], kSession));
      const localizer::Estimate now = localizer.estimate(odometry.utime);
      const bool is_lost = now.placement == localizer::Placement::kLost;
      if (is_lost && !was_lost) score.lost.push_back({seconds(odometry.utime), 0.0, now.reason});
      if (is_lost || was_lost) score.lost.back().duration = seconds(odometry.utime) - score.lost.back().begin;
      was_lost = is_lost;
    }
    localizer.observe(localizer::EncoderReading{odometry.utime, kSession, odometry.ticks.left, odometry.ticks.right});
    estimates.push_back(estimate_at(localizer, odometry.utime));
  }
  const LiveScore live = score_live(estimates, TruePath(drive.truth), times_after(drive, run.settling), run.settling);
  score.error = mean(live.settled);
  score.heading_error = mean(live.settled_heading);
  score.nees = mean(live.settled_nees);
  score.not_localised = live.settled_not_localised / static_cast<double>(live.settled.size());
  if (run.judging) score.wheels = localizer.wheel_judgement();
  return score;
}

double mean_bound(const Drive& drive, const robot::RobotDescription& robot, const WanderRun& run,
                  const simulator::BaseModelParameters& wheels) {
  const robot::RfidDescription& rfid = *robot.rfid;
  const robot::TagField& field = robot.floor_tags->field(run.tag_field);
  BoundInput input;
  input.reader = described_reader(rfid, field);
  for (const auto& round : drive.rounds) {
    input.rounds.push_back({seconds(round.utime) - rfid.delay, seconds(round.utime)});
  }
  input.times = times_after(drive, run.settling);
  input.prior.position_variance = field_box(field).size().cwiseAbs2() / 12.0;
  input.prior.heading_variance = M_PI * M_PI / 3.0;
  input.prior.delay_variance = rfid.delay_sigma * rfid.delay_sigma;
  const EncoderNoise noise = encoder_noise(wheels, robot.base->track);
  std::vector<double> means;
  for (const Eigen::Matrix4d& bound : live_bound(input, TruePath(drive.truth), noise)) {
    means.push_back(mean_radial_error(bound.topLeftCorner<2, 2>()));
  }
  return mean(means);
}

}  // namespace markservo::experiments
