#pragma once

// Every message type of lcmtypes/, for tests that must hold for all of them.

#include <gtest/gtest.h>

#include <markservo/BaseCommand.hpp>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/ChannelStatus.hpp>
#include <markservo/Covariance3.hpp>
#include <markservo/DetectedMark.hpp>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/LocatedMark.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/MarkMatches.hpp>
#include <markservo/MarkPatch.hpp>
#include <markservo/MarkView.hpp>
#include <markservo/PaperLocalisation.hpp>
#include <markservo/Pose2.hpp>
#include <markservo/PoseCovariance2.hpp>
#include <markservo/RfidTagHit.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SimBody.hpp>
#include <markservo/SimControl.hpp>
#include <markservo/SimMark.hpp>
#include <markservo/SimParameter.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/SonarEcho.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/StereoCalibration.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <markservo/Vector3.hpp>
#include <markservo/WheelOdometry.hpp>

namespace markservo {

using AllTypes =
    ::testing::Types<BaseCommand, BaseGoal, BaseStatus, ChannelStatus, Covariance3, DetectedMark, JointCommand,
                     JointState, LocatedMark, MarkDetection, MarkMatches, MarkPatch, MarkView, PaperLocalisation, Pose2,
                     PoseCovariance2, RfidTagHit, RfidTagHits, RobotPose, ServiceStatus, ServoGoal, ServoStatus,
                     SimBaseTruth, SimBody, SimControl, SimMark, SimParameter, SimTruth, SonarEcho, SonarScan,
                     StereoCalibration, StereoFrame, StereoMatches, StopRequest, StopState, TargetPose, TaskCommand,
                     TaskState, Vector3, WheelOdometry>;

}  // namespace markservo
