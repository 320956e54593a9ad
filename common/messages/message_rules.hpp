#pragma once

// What a well-formed message must also satisfy before it is worked on or sent: finite numbers, possible sizes, states
// that exist, lengths that agree, harmless texts. One trait per type that has a channel; a type without one cannot be
// subscribed or advertised. Types are only declared here, so that a change of one is felt by those who use it.
//
//   violation(message)       the reason why not, or an empty text
//   clean_texts(message)     of types with texts: makes those that its writer composed fit to be sent (text.hpp)
//   must_be_obeyed(message)  of STOP and TASK_COMMAND: whether the message is obeyed whatever else it says
//   mend(message)            of the same: makes the rest of such a message harmless

#include <string>
#include <type_traits>

#include "common/messages/message_identity.hpp"
#include "common/messages/message_traits.hpp"

namespace markservo {
class BaseCommand;
class BaseGoal;
class BaseStatus;
class JointCommand;
class JointState;
class LearnRequest;
class LearnResult;
class MarkDetection;
class ProcessStatus;
class RecorderStatus;
class RfidTagHits;
class RobotPose;
class ServiceStatus;
class ServoGoal;
class ServoStatus;
class SimBaseTruth;
class SimControl;
class SimTruth;
class SonarScan;
class StereoFrame;
class StereoMatches;
class StopRequest;
class StopState;
class TargetPose;
class TaskCommand;
class TaskState;
class WheelOdometry;
}  // namespace markservo

namespace markservo::messages {

// A new type's rules are declared below and written in the file of its family.
template <class M>
struct MessageRules;

template <>
struct MessageRules<StereoFrame> {
  static std::string violation(const StereoFrame& frame);
};
template <>
struct MessageRules<MarkDetection> {
  static std::string violation(const MarkDetection& detection);
  static void clean_texts(MarkDetection& detection);
};
template <>
struct MessageRules<LearnRequest> {
  static std::string violation(const LearnRequest& request);
  static void clean_texts(LearnRequest& request);
};
template <>
struct MessageRules<LearnResult> {
  static std::string violation(const LearnResult& result);
  static void clean_texts(LearnResult& result);
};
template <>
struct MessageRules<TargetPose> {
  static std::string violation(const TargetPose& pose);
  static void clean_texts(TargetPose& pose);
};
template <>
struct MessageRules<StereoMatches> {
  static std::string violation(const StereoMatches& matches);
  static void clean_texts(StereoMatches& matches);
};
template <>
struct MessageRules<ServoGoal> {
  static std::string violation(const ServoGoal& goal);
  static void clean_texts(ServoGoal& goal);
};
template <>
struct MessageRules<ServoStatus> {
  static std::string violation(const ServoStatus& status);
  static void clean_texts(ServoStatus& status);
};
template <>
struct MessageRules<JointCommand> {
  static std::string violation(const JointCommand& command);
};
template <>
struct MessageRules<JointState> {
  static std::string violation(const JointState& state);
};
template <>
struct MessageRules<BaseGoal> {
  static std::string violation(const BaseGoal& goal);
};
template <>
struct MessageRules<BaseStatus> {
  static std::string violation(const BaseStatus& status);
  static void clean_texts(BaseStatus& status);
};
template <>
struct MessageRules<BaseCommand> {
  static std::string violation(const BaseCommand& command);
};
template <>
struct MessageRules<WheelOdometry> {
  static std::string violation(const WheelOdometry& odometry);
};
template <>
struct MessageRules<SonarScan> {
  static std::string violation(const SonarScan& scan);
};
template <>
struct MessageRules<RfidTagHits> {
  static std::string violation(const RfidTagHits& hits);
  static void clean_texts(RfidTagHits& hits);
};
template <>
struct MessageRules<RobotPose> {
  static std::string violation(const RobotPose& pose);
  static void clean_texts(RobotPose& pose);
};
template <>
struct MessageRules<TaskCommand> {
  static std::string violation(const TaskCommand& command);
  static void clean_texts(TaskCommand& command);
  static bool must_be_obeyed(const TaskCommand& command);
  static void mend(TaskCommand& command);
};
template <>
struct MessageRules<TaskState> {
  static std::string violation(const TaskState& state);
  static void clean_texts(TaskState& state);
};
template <>
struct MessageRules<StopRequest> {
  static std::string violation(const StopRequest& request);
  static void clean_texts(StopRequest& request);
  static bool must_be_obeyed(const StopRequest& request);
  static void mend(StopRequest& request);
};
template <>
struct MessageRules<StopState> {
  static std::string violation(const StopState& state);
  static void clean_texts(StopState& state);
};
template <>
struct MessageRules<ServiceStatus> {
  static std::string violation(const ServiceStatus& status);
  static void clean_texts(ServiceStatus& status);
};
template <>
struct MessageRules<ProcessStatus> {
  static std::string violation(const ProcessStatus& status);
  static void clean_texts(ProcessStatus& status);
};
template <>
struct MessageRules<RecorderStatus> {
  static std::string violation(const RecorderStatus& status);
  static void clean_texts(RecorderStatus& status);
};
template <>
struct MessageRules<SimControl> {
  static std::string violation(const SimControl& control);
  static void clean_texts(SimControl& control);
};
template <>
struct MessageRules<SimTruth> {
  static std::string violation(const SimTruth& truth);
  static void clean_texts(SimTruth& truth);
};
template <>
struct MessageRules<SimBaseTruth> {
  static std::string violation(const SimBaseTruth& truth);
};

template <class M, class = void>
struct has_rules : std::false_type {};
template <class M>
struct has_rules<M, std::void_t<decltype(&MessageRules<M>::violation)>> : std::true_type {};

template <class M, class = void>
struct has_texts : std::false_type {};
template <class M>
struct has_texts<M, std::void_t<decltype(&MessageRules<M>::clean_texts)>> : std::true_type {};

template <class M, class = void>
struct may_have_to_be_obeyed : std::false_type {};
template <class M>
struct may_have_to_be_obeyed<M, std::void_t<decltype(&MessageRules<M>::must_be_obeyed)>> : std::true_type {};

// Its type's rules and those of all: what a bus asks of a message before it hands it over or sends it.
template <class M>
std::string broken_rule(const M& message) {
  static_assert(has_rules<M>::value, "a type with a channel needs its rules: common/messages/message_rules.hpp");
  std::string why = violation(identity_of(message));
  return why.empty() ? MessageRules<M>::violation(message) : why;
}

// True for a message that is obeyed whatever else it says: STOP of kind STOP, TASK_COMMAND of kind ABORT. It then has
// been made harmless.
template <class M>
bool mend_if_it_must_be_obeyed(M& message) {
  if constexpr (may_have_to_be_obeyed<M>::value) {
    if (!MessageRules<M>::must_be_obeyed(message)) return false;
    MessageRules<M>::mend(message);
    return true;
  }
  return false;
}

// Makes the texts that a message's writer composed fit to be sent.
template <class M>
void clean_texts(M& message) {
  if constexpr (has_texts<M>::value) MessageRules<M>::clean_texts(message);
}

}  // namespace markservo::messages
