#pragma once

// The types that have a channel, in the order of their numbers in the inputs of messages_fuzz: new ones go last.

#include <markservo/ServiceStatus.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TaskState.hpp>

#include "common/bus/message_rules.hpp"

namespace markservo::fuzz {

template <class... Types>
struct Channels {};

using ChannelTypes =
    Channels<StereoFrame, MarkDetection, TargetPose, StereoMatches, ServoGoal, ServoStatus, JointCommand, JointState,
             TaskCommand, TaskState, StopRequest, StopState, ServiceStatus, SimControl, SimTruth, RfidTagHits,
             WheelOdometry, SonarScan, RobotPose, BaseGoal, BaseStatus, BaseCommand, SimBaseTruth>;

}  // namespace markservo::fuzz
