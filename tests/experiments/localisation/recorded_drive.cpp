#include "tests/experiments/localisation/recorded_drive.hpp"

#include <utility>

namespace markservo::experiments {

Drive record_drive(const robot::RobotDescription& robot, const simulator::BaseRigParameters& parameters,
                   const geometry::PlanePose& start, double duration, const Steering& steer, std::uint64_t seed) {
  simulator::BaseRig rig(robot, parameters, start, seed, kEpoch_us);
  Drive drive;
  const auto take = [&] {
    simulator::BaseOutputs outputs = rig.take_due();
    for (auto& round : outputs.rounds) drive.rounds.push_back(std::move(round));
    if (!outputs.odometry) return;
    const simulator::BaseTruth truth = rig.truth();
    drive.odometry.push_back(*outputs.odometry);
    drive.truth.push_back({seconds(outputs.odometry->utime),
                           {truth.pose.x, truth.pose.y},
                           truth.pose.heading,
                           truth.speed,
                           truth.turn_rate,
                           truth.wheel_travel,
                           truth.turned});
    const Eigen::Vector2d command = steer(truth, drive.truth.back().time);
    rig.command(command[0], command[1]);
  };
  take();
  while (seconds(rig.utime()) < duration) {
    rig.step();
    take();
  }
  return drive;
}

}  // namespace markservo::experiments
