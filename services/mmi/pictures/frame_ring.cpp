#include "services/mmi/pictures/frame_ring.hpp"

#include <algorithm>
#include <markservo/channels.hpp>
#include <vector>

#include "common/time/seconds_between.hpp"

namespace markservo::mmi {
namespace {

constexpr std::array<std::pair<std::string_view, FramePart>, kFrameParts> kParts{{
    {channels::kMarkDetection.name, FramePart::kDetection},
    {channels::kStereoMatches.name, FramePart::kMatches},
    {channels::kTargetPose.name, FramePart::kPose},
    {channels::kServoStatus.name, FramePart::kServo},
}};
constexpr std::string_view kCommand = channels::kJointCommand.name;  // ends the chain, but is drawn on no picture

constexpr double kSlack = 1.5;  // of the median, within which most answers come

auto part_of(std::string_view channel) {
  return std::find_if(kParts.begin(), kParts.end(), [channel](const auto& known) { return known.first == channel; });
}

}  // namespace

void FrameRing::add(const reflection::Fields& fields, Bytes bytes, std::int64_t at, double now) {
  auto frame = std::make_shared<Frame>();
  frame->session = reflection::integer_in(fields, "session", 0);
  frame->seq = reflection::integer_in(fields, "seq", 0);
  frame->utime = reflection::integer_in(fields, "utime", 0);
  frame->at = at;
  frame->heard = now;
  frame->bytes = std::move(bytes);
  frames_.push_back(std::move(frame));
  if (frames_.size() > parameters_.frames) frames_.pop_front();
  patience_ = patience_by_delays();
}

bool FrameRing::is_answer(std::string_view channel) {
  return channel == kCommand || part_of(channel) != kParts.end();
}

void FrameRing::join(std::string_view channel, const reflection::Fields& fields, const Bytes& bytes, std::int64_t at) {
  const std::int64_t session = reflection::integer_in(fields, "frame_session", 0);
  const std::int64_t seq = reflection::integer_in(fields, "frame_seq", 0);
  const auto frame = std::find_if(frames_.rbegin(), frames_.rend(),
                                  [&](const auto& one) { return one->session == session && one->seq == seq; });
  if (frame == frames_.rend()) return;
  const auto part = part_of(channel);
  if (part != kParts.end()) (*frame)->parts[static_cast<std::size_t>(part->second)] = bytes;
  auto& delays = delays_[std::string(channel)];
  delays.push_back(seconds_between((*frame)->at, at));
  if (delays.size() > parameters_.delays) delays.pop_front();
}

double FrameRing::patience_by_delays() const {
  double slowest = 0.0;
  for (const auto& [channel, median] : delays()) slowest = std::max(slowest, median);
  return std::clamp(kSlack * slowest, parameters_.patience, parameters_.patience_max);
}

std::shared_ptr<const Frame> FrameRing::ready(double now) const {
  const auto is_ready = [&](const std::shared_ptr<Frame>& frame) {
    const bool complete = std::all_of(frame->parts.begin(), frame->parts.end(), [](const Bytes& part) { return part; });
    return complete || now - frame->heard >= patience_;
  };
  const auto found = std::find_if(frames_.rbegin(), frames_.rend(), is_ready);
  return found == frames_.rend() ? nullptr : *found;
}

std::shared_ptr<const Frame> FrameRing::of(std::int64_t at) const {
  const auto found = std::find_if(frames_.rbegin(), frames_.rend(), [at](const auto& one) { return one->at == at; });
  return found == frames_.rend() ? nullptr : *found;
}

std::map<std::string, double> FrameRing::delays() const {
  std::map<std::string, double> medians;
  for (const auto& [channel, delays] : delays_) {
    std::vector<double> sorted(delays.begin(), delays.end());
    const auto middle = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::nth_element(sorted.begin(), middle, sorted.end());
    medians[channel] = *middle;
  }
  return medians;
}

}  // namespace markservo::mmi
