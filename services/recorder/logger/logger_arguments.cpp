#include "services/recorder/logger/logger_arguments.hpp"

#include <algorithm>
#include <charconv>
#include <markservo/channels.hpp>

#include "common/bus/bus_url.hpp"

namespace markservo::recorder {
namespace {

constexpr const char* kBufferKey = "recv_buf_size=";
constexpr const char* kBuffer = "4194304";              // bytes, as in the default URL: raw frames need 2 MB
constexpr const char* kDefaultGroup = "239.255.76.67";  // liblcm's, where the URL names none

// On disk within so many ms of being heard: what a killed lcm-logger held longer is lost.
constexpr int kFlush_ms = 250;

constexpr std::int64_t kLeastUnwritten_mb = 100;
constexpr std::int64_t kMostUnwritten_mb = 1000;

}  // namespace

std::string with_receive_buffer(const std::string& lcm_url) {
  if (!bus::is_udpm(lcm_url) || lcm_url.find(kBufferKey) != std::string::npos) return lcm_url;
  return lcm_url + (lcm_url.find('?') == std::string::npos ? "?" : "&") + kBufferKey + kBuffer;
}

std::optional<std::int64_t> asked_receive_buffer(const std::string& lcm_url) {
  const std::size_t at = lcm_url.find(kBufferKey);
  if (at == std::string::npos) return std::nullopt;
  const char* digits = lcm_url.data() + at + std::string(kBufferKey).size();
  std::int64_t bytes = 0;
  const auto result = std::from_chars(digits, lcm_url.data() + lcm_url.size(), bytes);
  if (result.ec != std::errc() || bytes < 0) return std::nullopt;
  return bytes;
}

std::optional<std::string> multicast_group(const std::string& lcm_url) {
  if (!bus::is_udpm(lcm_url)) return std::nullopt;
  const std::size_t begin = std::string("udpm://").size();
  const std::string group = lcm_url.substr(begin, lcm_url.find_first_not_of("0123456789.", begin) - begin);
  return group.empty() ? kDefaultGroup : group;
}

std::string channel_expression(bool frames, const std::string& robot) {
  const std::string prefix = robot.empty() ? "" : robot + "/";
  const std::string any_prefix = robot.empty() ? "(.*/)?" : prefix;
  std::string left_out = channels::kRecorderStatus.name;
  if (!frames) left_out = "(" + left_out + "|" + channels::kStereoFrame.name + ")";
  return "(?!" + any_prefix + left_out + "$)" + prefix + ".*";
}

std::int64_t unwritten_megabytes(std::int64_t available_memory_kib) {
  return std::clamp(available_memory_kib / 4096, kLeastUnwritten_mb, kMostUnwritten_mb);
}

std::vector<std::string> logger_arguments(const RecordingPlan& plan, std::int64_t available_memory_kib,
                                          const std::string& path) {
  std::vector<std::string> arguments = {
      "--lcm-url=" + plan.lcm_url,
      "--channel=" + channel_expression(plan.frames, plan.robot),
      "--max-unwritten-mb=" + std::to_string(unwritten_megabytes(available_memory_kib)),
      "--flush-interval=" + std::to_string(kFlush_ms),
  };
  // Not --quiet, which also hides that messages are dropped; not --increment or --rotate: the one swallows the next
  // argument, the other renames files while they are written.
  if (plan.split_mb) {
    arguments.emplace_back("-i");
    arguments.push_back("--split-mb=" + std::to_string(*plan.split_mb));
  }
  arguments.push_back(path);
  return arguments;
}

}  // namespace markservo::recorder
