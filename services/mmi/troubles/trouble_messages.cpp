#include "services/mmi/troubles/trouble_messages.hpp"

#include <lcm/lcm_coretypes.h>

#include <cmath>
#include <iterator>
#include <limits>
#include <markservo/BaseStatus.hpp>
#include <markservo/ProcessStatus.hpp>
#include <markservo/RecorderStatus.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskState.hpp>
#include <markservo/channels.hpp>

#include "common/bus/safe_decode.hpp"
#include "common/messages/message_rules.hpp"
#include "common/messages/state_codes.hpp"
#include "common/reflection/message_value.hpp"
#include "services/mmi/troubles/watches/service_reason.hpp"

namespace markservo::mmi {
namespace {

using messages::code_of;
using messages::state_of;

static_assert(code_of(ProcessState::kStopped) == ProcessStatus::STOPPED);
static_assert(code_of(ProcessState::kStarting) == ProcessStatus::STARTING);
static_assert(code_of(ProcessState::kRunning) == ProcessStatus::RUNNING);
static_assert(code_of(ProcessState::kSilent) == ProcessStatus::SILENT);
static_assert(code_of(ProcessState::kWaiting) == ProcessStatus::WAITING);
static_assert(code_of(ProcessState::kEnded) == ProcessStatus::ENDED);
static_assert(code_of(ProcessState::kFailed) == ProcessStatus::FAILED);

TaskWord word_of(const TaskState& message, std::int64_t at) {
  return {at, state_of<TaskPhase>(message.state), state_of<TaskResult>(message.result), message.target, message.reason};
}

ServoWord word_of(const ServoStatus& message, std::int64_t at) {
  const Vector3& error = message.error_C;
  return {at, state_of<ServoState>(message.state), message.settled != 0, std::hypot(error.x, error.y, error.z),
          message.reason};
}

BaseWord word_of(const BaseStatus& message, std::int64_t at) {
  return {at, state_of<BaseState>(message.state), message.distance, message.reason};
}

PoseWord word_of(const RobotPose& message, std::int64_t at) {
  return {at,
          state_of<LocalisationState>(message.state),
          {message.pose.x, message.pose.y, message.pose.heading},
          std::sqrt(message.covariance.xx),
          std::sqrt(message.covariance.yy),
          message.reason};
}

StopWord word_of(const StopState& message, std::int64_t at) {
  return {at, message.device, message.latched != 0, message.request_session != 0, message.reason};
}

MarksWord word_of(const TargetPose& message, std::int64_t at) {
  MarksWord word{at, {}};
  for (const LocatedMark& mark : message.marks) {
    word.marks.push_back({mark.name, mark.role == LocatedMark::ROLE_MANIPULATOR, state_of<MarkStatus>(mark.status)});
  }
  return word;
}

ServiceWord word_of(const ServiceStatus& message, std::int64_t at) {
  ServiceWord word{at, message.session, message.name, message.host, message.pid, message.state, message.reason, {}};
  for (const ChannelStatus& channel : message.channels) {
    word.channels.push_back(
        {without_robot(channel.channel), channel.received, channel.lost, channel.refused, channel.second_writer != 0});
  }
  return word;
}

ProcessWord word_of(const ProcessStatus& message, std::int64_t at) {
  return {at, message.name, message.host, state_of<ProcessState>(message.state), message.pid, message.why};
}

RecorderWord word_of(const RecorderStatus& message, std::int64_t at) {
  return {at,
          message.folder,
          message.host,
          message.recording != 0,
          message.bytes,
          message.free_bytes,
          message.parts,
          message.why};
}

// Whom a message is told to.
struct Listeners {
  TroubleWatch& troubles;
  RobotState& state;
};

template <class Word>
void tell(const Word& word, double now, const Listeners& listeners) {
  listeners.troubles.observe(word, now);
  constexpr bool is_of_state = std::is_same_v<Word, TaskWord> || std::is_same_v<Word, ServoWord> ||
                               std::is_same_v<Word, BaseWord> || std::is_same_v<Word, PoseWord> ||
                               std::is_same_v<Word, RecorderWord>;
  if constexpr (is_of_state) listeners.state.observe(word);
}

// Decodes the message and tells it; why not, or an empty text. Nothing is told of one that breaks a rule.
template <class M>
std::string take(const void* data, std::size_t size, AnyWord any, double now, const Listeners& listeners) {
  const auto decoded = bus::safe_decode<M>(data, size);
  if (!decoded.ok) return decoded.error;
  if (std::string why = messages::broken_rule(decoded.message); !why.empty()) return why;
  if constexpr (std::is_same_v<M, StopState>) {
    any.writer_of = decoded.message.device;
    any.one_writes = true;
  }
  listeners.troubles.observe(any, now);
  tell(word_of(decoded.message, any.at), now, listeners);
  return {};
}

using Take = std::string (*)(const void*, std::size_t, AnyWord, double, const Listeners&);

struct Row {
  const char* channel;
  Take take;
};

constexpr Row kTold[] = {
    {channels::kTaskState.name, &take<TaskState>},           {channels::kServoStatus.name, &take<ServoStatus>},
    {channels::kBaseStatus.name, &take<BaseStatus>},         {channels::kRobotPose.name, &take<RobotPose>},
    {channels::kStopState.name, &take<StopState>},           {channels::kTargetPose.name, &take<TargetPose>},
    {channels::kServiceStatus.name, &take<ServiceStatus>},   {channels::kProcessStatus.name, &take<ProcessStatus>},
    {channels::kRecorderStatus.name, &take<RecorderStatus>},
};

// Type, time and session, which every message of the table begins with.
std::string read_head(const channels::Entry& entry, const void* data, std::size_t size, AnyWord* any) {
  std::int64_t numbers[3] = {};  // fingerprint, utime, session
  if (size < sizeof numbers || size > static_cast<std::size_t>(std::numeric_limits<int>::max())) {
    return entry.name + std::string(": ") + std::to_string(size) + " bytes; allowed: a " + entry.type;
  }
  __int64_t_decode_array(data, 0, static_cast<int>(size), numbers, static_cast<int>(std::size(numbers)));
  const auto* type = reflection::TypeCatalog::ours().find(static_cast<std::uint64_t>(numbers[0]));
  if (type == nullptr || reflection::shown_name(*type) != entry.type) {
    return entry.name + std::string(": a message of another type or version; allowed: ") + entry.type;
  }
  any->utime = numbers[1];
  any->session = numbers[2];
  messages::Identity identity;
  identity.utime = any->utime;
  identity.session = any->session;
  return messages::violation(identity);
}

}  // namespace

std::string observe_message(const std::string& channel, const void* data, std::size_t size, std::int64_t at, double now,
                            TroubleWatch& troubles, RobotState& state) {
  const channels::Entry* entry = channels::find(channel);
  if (entry == nullptr) return {};
  AnyWord any;
  any.at = at;
  any.channel = channel;
  any.one_writes = entry->second != channels::Second::kAllowed;
  if (std::string why = read_head(*entry, data, size, &any); !why.empty()) return why;
  for (const Row& row : kTold) {
    if (channel == row.channel) return row.take(data, size, any, now, {troubles, state});
  }
  troubles.observe(any, now);
  return {};
}

}  // namespace markservo::mmi
