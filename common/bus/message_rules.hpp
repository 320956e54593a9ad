#pragma once

// What a well-formed message must also satisfy before it is worked on or sent: finite numbers, possible sizes, lengths
// that agree. One function per type; the reason why not, or an empty text. A type without rules passes.

#include <markservo/BaseCommand.hpp>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/SimControl.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/WheelOdometry.hpp>
#include <string>

#include "common/bus/message_traits.hpp"

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
std::string violation(const RfidTagHits& hits);
std::string violation(const WheelOdometry& odometry);
std::string violation(const SonarScan& scan);
std::string violation(const RobotPose& pose);
std::string violation(const BaseGoal& goal);
std::string violation(const BaseStatus& status);
std::string violation(const BaseCommand& command);

template <class M>
std::string violation(const M&) {
  return {};
}

// Times (us) and numbers beyond this are not real: the year 2255, or 9 million years at 30 Hz. Sums of a few never
// overflow, and every one is exact as a double.
inline constexpr int64_t kMaxCount = int64_t{1} << 53;

// What every message says of itself: a possible time, in streams a session and a number, and in an answer the frame's
// time as its own.
template <class M>
std::string identity_violation(const M& message) {
  const auto wrong = [](const char* field, int64_t value, const std::string& allowed) {
    return std::string(field) + " is " + std::to_string(value) + "; allowed: " + allowed;
  };
  if constexpr (has_utime<M>::value) {
    if (message.utime < 0 || message.utime > kMaxCount) return wrong("utime", message.utime, "0 to 2^53 us");
  }
  if constexpr (has_seq<M>::value) {
    if (message.session < 1) return wrong("session", message.session, "1 or more");
    if (message.seq < 0 || message.seq > kMaxCount) return wrong("seq", message.seq, "0 to 2^53");
  }
  if constexpr (answers_frame<M>::value) {
    if (message.frame_utime != message.utime) {
      return wrong("frame_utime", message.frame_utime, "utime, " + std::to_string(message.utime));
    }
    if (message.frame_seq < 0 || message.frame_seq > kMaxCount) {
      return wrong("frame_seq", message.frame_seq, "0 to 2^53");
    }
  }
  return {};
}

// Both at once: what a bus asks of a message before it hands it over or sends it.
template <class M>
std::string broken_rule(const M& message) {
  const std::string why = identity_violation(message);
  return why.empty() ? violation(message) : why;
}

}  // namespace markservo::bus
