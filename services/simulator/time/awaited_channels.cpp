#include "services/simulator/time/awaited_channels.hpp"

#include <algorithm>
#include <markservo/channels.hpp>

namespace markservo::simulator {
namespace {

const std::vector<std::string>& odometry_answers() {
  static const std::vector<std::string> names = {channels::kBaseCommand.name, channels::kBaseStatus.name,
                                                 channels::kRobotPose.name};
  return names;
}

}  // namespace

const std::vector<std::string>& answering_channels() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all = {channels::kJointCommand.name,  channels::kTaskState.name,
                                    channels::kServoStatus.name,   channels::kTargetPose.name,
                                    channels::kMarkDetection.name, channels::kSimControl.name};
    all.insert(all.end(), odometry_answers().begin(), odometry_answers().end());
    return all;
  }();
  return names;
}

bool answers_odometry(const std::string& channel) {
  const auto& names = odometry_answers();
  return std::find(names.begin(), names.end(), channel) != names.end();
}

AwaitedChannels awaited_channels(const std::vector<std::string>& channels) {
  AwaitedChannels awaited;
  for (const std::string& channel : channels) {
    (answers_odometry(channel) ? awaited.of_odometries : awaited.of_frames).push_back(channel);
  }
  return awaited;
}

}  // namespace markservo::simulator
