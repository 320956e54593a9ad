#include "services/log-tool/log_merge.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <string_view>
#include <unordered_map>

#include "services/log-tool/play_choice.hpp"
#include "services/log-tool/time_steps.hpp"

namespace markservo::log_tool {
namespace {

// Of the smaller log's messages: below this share a few of the same content tell of no second recording.
constexpr double kShareTold = 0.05;

struct Span {
  std::int64_t first = 0;  // us
  std::int64_t last = 0;
};

Span span_of(const std::vector<logs::LogEvent>& events) {
  const auto [first, last] = std::minmax_element(
      events.begin(), events.end(), [](const logs::LogEvent& a, const logs::LogEvent& b) { return a.utime < b.utime; });
  return {first->utime, last->utime};
}

// The same message may come a thousand times in one log; here it counts once a pair.
std::int64_t messages_twice(const std::vector<MergeInput>& inputs) {
  std::unordered_map<std::size_t, std::pair<std::size_t, std::int64_t>> heard;  // by content: last input, times there
  std::int64_t twice = 0;
  for (std::size_t input = 0; input < inputs.size(); ++input) {
    std::unordered_map<std::size_t, std::int64_t> here;
    for (const logs::LogEvent& event : inputs[input].events) {
      if (event.channel == kLcmSelfTest) continue;
      const std::hash<std::string_view> hash;
      const std::size_t content = hash(event.channel) * 31 + hash(event.data.text());
      const std::int64_t times = ++here[content];
      const auto before = heard.find(content);
      if (before != heard.end() && before->second.first < input && times <= before->second.second) ++twice;
    }
    for (const auto& [content, times] : here) heard[content] = {input, times};
  }
  return twice;
}

std::int64_t messages_of_smallest(const std::vector<MergeInput>& inputs) {
  std::int64_t smallest = std::numeric_limits<std::int64_t>::max();
  for (const MergeInput& input : inputs) {
    const auto messages = std::count_if(input.events.begin(), input.events.end(),
                                        [](const logs::LogEvent& event) { return event.channel != kLcmSelfTest; });
    if (messages > 0) smallest = std::min<std::int64_t>(smallest, messages);
  }
  return smallest;
}

}  // namespace

Merge merged(const std::vector<MergeInput>& inputs) {
  Merge merge;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const std::vector<logs::LogEvent>& events = inputs[i].events;
    merge.late += time_steps(events).late;
    merge.events.insert(merge.events.end(), events.begin(), events.end());
    if (i == 0 || events.empty() || inputs[i - 1].events.empty()) continue;
    const Span before = span_of(inputs[i - 1].events);
    const Span now = span_of(events);
    const double apart =
        std::max(logs::seconds_apart(before.last, now.first), logs::seconds_apart(now.last, before.first));
    if (apart <= 0.0) continue;
    merge.remarks.push_back(
        fmt::format("{} and {} do not overlap: {} lie between them (if they were recorded together, "
                    "their clocks differ)",
                    inputs[i - 1].name, inputs[i].name, duration_text(apart)));
  }
  merge.events = sorted_by_time(std::move(merge.events));
  merge.twice = messages_twice(inputs);
  if (static_cast<double>(merge.twice) > kShareTold * static_cast<double>(messages_of_smallest(inputs))) {
    merge.remarks.push_back(
        fmt::format("{} in more than one of the logs (one bus, recorded twice?): all are kept",
                    merge.twice == 1 ? "1 message stands" : fmt::format("{} messages stand", merge.twice)));
  }
  return merge;
}

}  // namespace markservo::log_tool
