#pragma once

// What a well-formed message must also satisfy before it is worked on or sent: finite numbers, possible sizes, lengths
// that agree. One function per type; the reason why not, or an empty text. A type without rules passes.

#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/SimControl.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <string>

namespace markservo::bus {

std::string violation(const StereoFrame& frame);
std::string violation(const MarkDetection& detection);
std::string violation(const TargetPose& pose);
std::string violation(const ServoGoal& goal);
std::string violation(const ServoStatus& status);
std::string violation(const JointCommand& command);
std::string violation(const JointState& state);
std::string violation(const TaskCommand& command);
std::string violation(const SimControl& control);

template <class M>
std::string violation(const M&) {
  return {};
}

}  // namespace markservo::bus
