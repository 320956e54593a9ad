#pragma once

// The types that have a channel, in the order of their numbers in the inputs of messages_fuzz: new ones go last.

#include <markservo/BaseCommand.hpp>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/LearnRequest.hpp>
#include <markservo/LearnResult.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/ProcessStatus.hpp>
#include <markservo/RecorderStatus.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SimControl.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <markservo/WheelOdometry.hpp>

#include "common/messages/message_rules.hpp"

namespace markservo::fuzz {

template <class... Types>
struct Channels {};

using ChannelTypes =
    Channels<StereoFrame, MarkDetection, TargetPose, StereoMatches, ServoGoal, ServoStatus, JointCommand, JointState,
             TaskCommand, TaskState, StopRequest, StopState, ServiceStatus, SimControl, SimTruth, RfidTagHits,
             WheelOdometry, SonarScan, RobotPose, BaseGoal, BaseStatus, BaseCommand, SimBaseTruth, ProcessStatus,
             RecorderStatus, LearnRequest, LearnResult>;

}  // namespace markservo::fuzz
