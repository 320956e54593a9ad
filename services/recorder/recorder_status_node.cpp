#include "services/recorder/recorder_status_node.hpp"

#include <chrono>
#include <markservo/channels.hpp>
#include <utility>

#include "common/bus/host_name.hpp"
#include "common/bus/robot_channel.hpp"
#include "common/bus/session.hpp"
#include "common/time/clocks.hpp"

namespace markservo::recorder {
namespace {

constexpr std::int64_t kPeriod_us = 1'000'000;
constexpr std::int64_t kMegabyte = 1'000'000;

bool is_news(const RecordingWord& told, const RecordingWord& word) {
  return told.recording != word.recording || told.parts != word.parts || told.why != word.why;
}

}  // namespace

RecorderStatusNode::RecorderStatusNode(const RecordingPlan& plan, std::string folder)
    : folder_(std::move(folder)),
      bus_(plan.lcm_url, nullptr),
      statuses_(this, bus::robot_channel(plan.robot, channels::kRecorderStatus.name), bus::random_session()) {}

bool RecorderStatusNode::send(const bus::Outgoing& message) {
  const auto now = std::chrono::steady_clock::now();
  bus_.mend(now);
  return bus_.publish(message, now);
}

void RecorderStatusNode::tell(const RecordingWord& word, std::int64_t steady_us) {
  if (told_ && !is_news(*told_, word) && steady_us - told_us_ < kPeriod_us) return;
  told_ = word;
  told_us_ = steady_us;
  RecorderStatus status{};
  status.utime = wall_clock_us();
  status.folder = folder_;
  status.host = bus::host_name();
  status.recording = word.recording ? 1 : 0;
  status.bytes = word.bytes;
  status.free_bytes = kMegabyte * word.free_mb;
  status.parts = word.parts;
  status.why = word.why;
  statuses_.publish(status);
}

}  // namespace markservo::recorder
