#include "services/log-tool/time_steps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "services/log-tool/time_walk.hpp"

namespace markservo::log_tool {
namespace {

const char* plural(std::int64_t count) {
  return count == 1 ? "" : "s";
}

}  // namespace

TimeSteps time_steps(const std::vector<logs::LogEvent>& events) {
  TimeSteps steps;
  if (events.empty()) return steps;
  const std::int64_t first = events.front().utime;
  std::int64_t newest = first;
  TimeWalk walk;
  walk.to(first);
  for (std::size_t i = 1; i < events.size(); ++i) {
    const std::int64_t before = events[i - 1].utime;
    const double step_s = logs::seconds_apart(before, events[i].utime);
    if (step_s < 0.0) ++steps.back;
    steps.farthest_back = std::max(steps.farthest_back, -logs::seconds_apart(newest, events[i].utime));
    if (events[i].utime < newest) ++steps.late;
    newest = std::max(newest, events[i].utime);
    const TimeWalk::Step step = walk.to(events[i].utime);
    if (step.jumped) ++steps.jumps;
    if (step.silent_s > kSilence_s) {
      steps.silences.push_back({logs::seconds_apart(first, events[i].utime) - step.silent_s, step.silent_s});
    }
  }
  return steps;
}

std::vector<logs::LogEvent> sorted_by_time(std::vector<logs::LogEvent> events) {
  std::stable_sort(events.begin(), events.end(),
                   [](const logs::LogEvent& a, const logs::LogEvent& b) { return a.utime < b.utime; });
  for (std::size_t i = 0; i < events.size(); ++i) events[i].number = static_cast<std::int64_t>(i);
  return events;
}

std::string duration_text(double seconds) {
  constexpr double kMinute = 60.0;
  constexpr double kHour = 3600.0;
  constexpr double kDay = 86400.0;
  const double size = std::abs(seconds);
  if (size < 0.095 && size > 0.0) return fmt::format("{:.1f} ms", 1e3 * seconds);
  if (size < 2.0 * kMinute) return fmt::format("{:.1f} s", seconds);
  if (size < 2.0 * kHour) return fmt::format("{:.1f} min", seconds / kMinute);
  if (size < 2.0 * kDay) return fmt::format("{:.1f} h", seconds / kHour);
  return fmt::format("{:.0f} days", seconds / kDay);
}

std::string disorder_text(const TimeSteps& steps) {
  if (steps.back == 0) return "";
  return fmt::format("{} time{} back, by {}{}: {} event{} out of order", steps.back, plural(steps.back),
                     steps.back == 1 ? "" : "up to ", duration_text(steps.farthest_back), steps.late,
                     steps.late == 1 ? " is" : "s are");
}

std::string silences_text(const TimeSteps& steps) {
  constexpr std::size_t kTold = 5;  // the longest
  if (steps.silences.empty()) return "";
  std::vector<Silence> longest = steps.silences;
  std::stable_sort(longest.begin(), longest.end(),
                   [](const Silence& a, const Silence& b) { return a.seconds > b.seconds; });
  const std::size_t more = longest.size() - std::min(longest.size(), kTold);
  longest.resize(longest.size() - more);
  std::string text = "nothing";
  for (std::size_t i = 0; i < longest.size(); ++i) {
    text += fmt::format("{} for {} after {}", i == 0 ? "" : ",", duration_text(longest[i].seconds),
                        duration_text(longest[i].after));
  }
  if (more > 0) text += fmt::format(" and {} more time{}", more, plural(static_cast<std::int64_t>(more)));
  return text;
}

}  // namespace markservo::log_tool
