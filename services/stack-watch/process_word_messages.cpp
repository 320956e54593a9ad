#include "services/stack-watch/process_word_messages.hpp"

#include <markservo/ProcessStatus.hpp>
#include <markservo/channels.hpp>

#include "common/bus/host_name.hpp"
#include "common/bus/robot_channel.hpp"
#include "common/bus/session.hpp"
#include "common/messages/message_rules.hpp"
#include "services/stack-watch/short_message_of.hpp"

namespace markservo::stack_watch {
namespace {

constexpr std::int8_t code_of(ProcessState state) {
  return static_cast<std::int8_t>(state);
}

static_assert(code_of(ProcessState::kStopped) == ProcessStatus::STOPPED);
static_assert(code_of(ProcessState::kStarting) == ProcessStatus::STARTING);
static_assert(code_of(ProcessState::kRunning) == ProcessStatus::RUNNING);
static_assert(code_of(ProcessState::kSilent) == ProcessStatus::SILENT);
static_assert(code_of(ProcessState::kWaiting) == ProcessStatus::WAITING);
static_assert(code_of(ProcessState::kEnded) == ProcessStatus::ENDED);
static_assert(code_of(ProcessState::kFailed) == ProcessStatus::FAILED);

}  // namespace

ProcessWordMessages::ProcessWordMessages(const std::string& robot)
    : channel_(bus::robot_channel(robot, channels::kProcessStatus.name)),
      host_(bus::host_name()),
      session_(bus::random_session()) {}

std::vector<std::vector<std::uint8_t>> ProcessWordMessages::next(const StackFindings& found, Telling telling,
                                                                 std::int64_t wall_us) {
  std::vector<std::vector<std::uint8_t>> datagrams;
  for (const ProcessWord& word : watch_.words(found, wall_us)) {
    const auto told = told_.find(word.name);
    const bool changed = told == told_.end() || told->second.state != word.state || told->second.pid != word.pid;
    if (telling == Telling::kChangedState && !changed) continue;
    told_.insert_or_assign(word.name, Told{word.state, word.pid});
    datagrams.push_back(datagram(word, wall_us));
  }
  return datagrams;
}

std::vector<std::uint8_t> ProcessWordMessages::datagram(const ProcessWord& word, std::int64_t wall_us) {
  ProcessStatus status{};
  status.utime = wall_us;
  status.session = session_;
  status.seq = ++seq_;
  status.name = word.name;
  status.host = host_;
  status.state = code_of(word.state);
  status.pid = word.pid;
  status.start_utime = word.start_utime;
  status.restarts = word.restarts;
  status.why = word.why;
  messages::clean_texts(status);
  return short_message_of(status, channel_);
}

}  // namespace markservo::stack_watch
