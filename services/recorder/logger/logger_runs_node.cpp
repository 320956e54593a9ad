#include "services/recorder/logger/logger_runs_node.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>

#include "common/bus/bus_url.hpp"
#include "common/time/clocks.hpp"
#include "services/recorder/folder/last_event.hpp"
#include "services/recorder/logger/interface_reader.hpp"
#include "services/recorder/logger/logger_arguments.hpp"
#include "services/recorder/logger/logger_readiness.hpp"
#include "services/recorder/proc_reader.hpp"

namespace markservo::recorder {
namespace {

constexpr std::int64_t kLook_us = 50'000;

// The last bytes of a file.
std::string end_of(const std::string& path, std::int64_t size) {
  std::ifstream file(path, std::ios::binary);
  file.seekg(std::max<std::int64_t>(0, size - static_cast<std::int64_t>(kLogEnd)));
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

bool LoggerRuns::begin() {
  start();
  const bool listens = await_listening();
  for (const std::string& place : held_places(folder_.parts())) folder_.remove(place);
  if (!listens) return false;
  interface_.reset();
  if (const auto group = multicast_group(plan_.lcm_url)) interface_ = interface_towards(*group);
  heard_until_ = wall_clock_us();
  return true;
}

void LoggerRuns::start() {
  const NextPart next = next_part(folder_.parts(), plan_.split_mb.has_value(), runs_);
  for (const std::string& place : next.places_to_hold) folder_.make_empty(place);
  words_.begin_run();
  logger_.emplace(logger_arguments(plan_, available_memory_kib(), folder_.file(next.file)), folder_.lock_descriptor());
  started_us_ = steady_clock_us();
  ++runs_;
}

bool LoggerRuns::await_listening() {
  using State = LoggerReadiness::State;
  LoggerReadiness readiness(bus::is_tcpq(plan_.lcm_url), steady_clock_us());
  State before = State::kStarting;
  while (true) {
    const LoggerSight sight{is_alive(), logger_->threads(), words().says_self_test_failed()};
    const State state = readiness.observe(sight, steady_clock_us());
    if (state == State::kTesting && before != state) listens_since_ = wall_clock_us();
    if (state == State::kListens || state == State::kFailed) return state == State::kListens;
    before = state;
    signals_.wait(kLook_us);
  }
}

std::int64_t LoggerRuns::pause_us() {
  return pace_.pause_us(steady_clock_us() - started_us_);
}

LoggerEnd LoggerRuns::end() {
  if (!logger_) return {};
  const LoggerEnd end = logger_->end();
  await_its_last_event();
  words();
  logger_.reset();
  return end;
}

// When only what runs it was killed it still writes what it holds.
void LoggerRuns::await_its_last_event() {
  constexpr std::int64_t kPatience_us = 3'000'000;
  const std::int64_t begin_us = steady_clock_us();
  while (logger_->logger_lives() && steady_clock_us() - begin_us < kPatience_us) signals_.wait(kLook_us);
}

bool LoggerRuns::can_hear() {
  if (interface_ && !interface_exists(*interface_)) return false;
  heard_until_ = wall_clock_us();
  return true;
}

std::int64_t LoggerRuns::missed_since() const {
  constexpr std::size_t kNewest = 2;  // a part that has just begun may hold no event yet
  std::vector<std::int64_t> last_events;
  const std::vector<Part> parts = folder_.parts();
  for (std::size_t i = parts.size(); i > 0 && parts.size() - i < kNewest; --i) {
    const std::string end = end_of(folder_.file(parts[i - 1].name), parts[i - 1].bytes);
    if (const auto utime = last_event_utime(end, wall_clock_us())) last_events.push_back(*utime);
  }
  return recorder::missed_since(last_events, listens_since_);
}

const LoggerWords& LoggerRuns::words() {
  if (logger_) words_.add(logger_->take_words());
  return words_;
}

}  // namespace markservo::recorder
