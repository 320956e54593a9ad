#include "services/mmi/scene/scene_messages.hpp"

#include <map>
#include <markservo/BaseStatus.hpp>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ProcessStatus.hpp>
#include <markservo/RecorderStatus.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <markservo/channels.hpp>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "common/bus/safe_decode.hpp"
#include "common/messages/message_rules.hpp"
#include "common/messages/state_codes.hpp"

namespace markservo::mmi {
namespace {

using messages::code_of;
using messages::state_of;

static_assert(code_of(robot::MarkRole::kTarget) == LocatedMark::ROLE_TARGET);
static_assert(code_of(robot::MarkRole::kManipulator) == LocatedMark::ROLE_MANIPULATOR);
static_assert(code_of(CommandKind::kStart) == TaskCommand::START);
static_assert(code_of(CommandKind::kAbort) == TaskCommand::ABORT);
static_assert(code_of(CommandKind::kHome) == TaskCommand::HOME);
static_assert(code_of(CommandKind::kDrive) == TaskCommand::DRIVE);
static_assert(code_of(ProcessState::kStopped) == ProcessStatus::STOPPED);
static_assert(code_of(ProcessState::kStarting) == ProcessStatus::STARTING);
static_assert(code_of(ProcessState::kRunning) == ProcessStatus::RUNNING);
static_assert(code_of(ProcessState::kSilent) == ProcessStatus::SILENT);
static_assert(code_of(ProcessState::kWaiting) == ProcessStatus::WAITING);
static_assert(code_of(ProcessState::kEnded) == ProcessStatus::ENDED);
static_assert(code_of(ProcessState::kFailed) == ProcessStatus::FAILED);

Eigen::Vector3d vector_of(const Vector3& v) {
  return {v.x, v.y, v.z};
}

Eigen::Matrix3d matrix_of(const Covariance3& c) {
  Eigen::Matrix3d matrix;
  matrix << c.xx, c.xy, c.xz,  //
      c.xy, c.yy, c.yz,        //
      c.xz, c.yz, c.zz;
  return matrix;
}

JointReport joint_report(bool commanded, std::int64_t utime, const std::vector<double>& position) {
  if (position.size() != robot::kNumJoints) {
    throw std::invalid_argument("num_joints is " + std::to_string(position.size()) +
                                "; allowed: " + std::to_string(robot::kNumJoints));
  }
  return {commanded, utime, {position[0], position[1], position[2]}};
}

Report report_of(const JointState& message) {
  return joint_report(false, message.utime, message.position);
}

Report report_of(const JointCommand& message) {
  return joint_report(true, message.utime, message.position);
}

Report report_of(const TargetPose& message) {
  TargetReport report{message.utime, message.frame_seq, {}};
  for (const LocatedMark& mark : message.marks) {
    report.marks.push_back({mark.name, state_of<robot::MarkRole>(mark.role), state_of<MarkStatus>(mark.status),
                            state_of<MarkCue>(mark.cue), vector_of(mark.p_C), matrix_of(mark.covariance),
                            vector_of(mark.normal_C)});
  }
  return report;
}

Report report_of(const ServoGoal& message) {
  return ServoGoalReport{message.kind == ServoGoal::SERVO, message.target, vector_of(message.p_TG_C)};
}

Report report_of(const RfidTagHits& message) {
  RoundReport report{message.utime, {}};
  for (const RfidTagHit& hit : message.hits) {
    report.hits.push_back({hit.uid, hit.utime, hit.rssi_known != 0 ? std::optional(hit.rssi) : std::nullopt});
  }
  return report;
}

Report report_of(const RobotPose& message) {
  return PoseReport{message.utime,
                    message.session,
                    state_of<LocalisationState>(message.state),
                    {message.pose.x, message.pose.y, message.pose.heading},
                    message.delay,
                    message.reason};
}

Report report_of(const TaskState& message) {
  return TaskReport{message.session, state_of<TaskPhase>(message.state), message.attempt, message.target,
                    message.reason};
}

Report report_of(const ServoStatus& message) {
  return ServoReport{message.session, state_of<ServoState>(message.state), message.settled != 0, message.reason};
}

Report report_of(const BaseStatus& message) {
  return BaseReport{message.session, state_of<BaseState>(message.state), message.reason};
}

Report report_of(const StopState& message) {
  return StopReport{message.session,         message.device,     message.latched != 0,
                    message.request_session, message.request_id, message.reason};
}

Report report_of(const StopRequest& message) {
  return StopRequestReport{message.session, message.request_id, message.kind == StopRequest::RESET, message.source,
                           message.reason};
}

Report report_of(const TaskCommand& message) {
  return CommandReport{message.session, message.command_id, state_of<CommandKind>(message.kind),
                       message.target,  message.carry != 0, message.drive != 0};
}

Report report_of(const ServiceStatus& message) {
  return ServiceReport{message.session, message.name, message.host, message.state, message.reason};
}

Report report_of(const ProcessStatus& message) {
  return ProcessReport{message.session,  message.name, message.host, state_of<ProcessState>(message.state),
                       message.restarts, message.why};
}

Report report_of(const RecorderStatus& message) {
  return RecorderReport{message.session,        message.folder, message.host,
                        message.recording != 0, message.parts,  message.why};
}

template <class M>
ReadReport read(const void* data, std::size_t size) {
  bus::Decoded<M> decoded = bus::safe_decode<M>(data, size);
  if (!decoded.ok) return {{}, decoded.error};
  if (!messages::mend_if_it_must_be_obeyed(decoded.message)) {
    if (std::string why = messages::broken_rule(decoded.message); !why.empty()) return {{}, why};
  }
  try {
    return {report_of(decoded.message), {}};
  } catch (const std::invalid_argument& error) {
    return {{}, error.what()};
  }
}

using Read = ReadReport (*)(const void* data, std::size_t size);

// The reader of a channel's messages, by the type that the table of channels gives it.
template <class M>
std::pair<const std::string_view, Read> reader_of(const channels::Channel<M>& channel) {
  return {channel.name, &read<M>};
}

}  // namespace

ReadReport read_report(const std::string& channel, const void* data, std::size_t size) {
  static const std::map<std::string_view, Read> kReaders = {
      reader_of(channels::kJointState),    reader_of(channels::kJointCommand),  reader_of(channels::kTargetPose),
      reader_of(channels::kServoGoal),     reader_of(channels::kRfidTagHits),   reader_of(channels::kRobotPose),
      reader_of(channels::kTaskState),     reader_of(channels::kServoStatus),   reader_of(channels::kBaseStatus),
      reader_of(channels::kStopState),     reader_of(channels::kStop),          reader_of(channels::kTaskCommand),
      reader_of(channels::kServiceStatus), reader_of(channels::kProcessStatus), reader_of(channels::kRecorderStatus)};
  const auto reader = kReaders.find(channel);
  return reader == kReaders.end() ? ReadReport{} : reader->second(data, size);
}

}  // namespace markservo::mmi
