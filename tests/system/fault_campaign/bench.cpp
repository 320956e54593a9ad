#include "tests/system/fault_campaign/bench.hpp"

#include <poll.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

#include "common/bus/safe_decode.hpp"
#include "common/time/seconds_between.hpp"

namespace markservo::campaign {
namespace {

constexpr int kTick_ms = 4;
constexpr std::int64_t kSample_us = 400'000;
constexpr std::int64_t kOwnReturns_us = 3'000'000;

// By its beginning: of a long one no more comes back.
std::size_t hash_of(const std::string& channel, std::int64_t size, const std::uint8_t* data, std::size_t available) {
  const std::hash<std::string_view> hash;
  return hash({reinterpret_cast<const char*>(data), std::min<std::size_t>(available, kWholeSize)}) ^ hash(channel) ^
         static_cast<std::size_t>(size);
}

// As scripts/stack understands a service's word.
bool is_ready(const std::string& state) {
  return state != "starting" && state != "waiting" && state != "stale";
}

template <class M>
bool decode(const KeptMessage& kept, M& message) {
  return bus::decode_into(message, kept.data.data(), kept.data.size()).empty();
}

}  // namespace

Bench::Bench(BenchFolders folders) : folders_(std::move(folders)), bus_(kPort), history_(folders_.out) {
  std::filesystem::create_directories(std::filesystem::path(folders_.out) / "printed");
}

std::int64_t Bench::now() {
  return std::chrono::duration_cast<std::chrono::microseconds>(std::chrono::system_clock::now().time_since_epoch())
      .count();
}

const std::vector<std::string>& Bench::services() {
  static const std::vector<std::string> all = {"simulator",      "rfid-localizer", "base-navigator", "mark-detector",
                                               "target-locator", "visual-servo",   "task-manager"};
  return all;
}

bool Bench::listen(double seconds, const std::function<bool()>& done) {
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!done || !done()) {
    if (std::chrono::steady_clock::now() >= end) return !done;
    pollfd waiting{bus_.descriptor(), POLLIN, 0};
    poll(&waiting, 1, kTick_ms);
    bus_.receive([this](const HeardMessage& message) { hear(message); });
    if (now() - sampled_ > kSample_us) sample_processes();
    if (task_) task_();
  }
  return true;
}

void Bench::hear(const HeardMessage& message) {
  const std::int64_t t = now();
  history_.heard(t, message.channel, message.size, message.data, message.available);
  while (!own_.empty() && t - own_.front().first > kOwnReturns_us) own_.pop_front();
  const std::size_t hash = hash_of(message.channel, message.size, message.data, message.available);
  const auto own = std::find_if(own_.begin(), own_.end(), [&](const auto& sent) { return sent.second == hash; });
  const bool foreign = own != own_.end();
  if (foreign) {
    own_.erase(own);
    ++own_heard_;
  } else {
    ++counts_[message.channel];
  }
  if (static_cast<std::int64_t>(message.available) != message.size || message.available > kWholeSize) return;
  KeptMessage kept{t, message.channel, {message.data, message.data + message.available}};
  if (!foreign) learn(kept);
  for (const auto& listener : listeners_) listener(kept, foreign);
  if (foreign && kept.channel != "STOP" && kept.channel != "TASK_COMMAND") return;
  if (!foreign) last_[kept.channel] = kept;
  kept_.push_back(std::move(kept));
  if (kept_.size() > kKept) kept_.pop_front();
}

void Bench::learn(const KeptMessage& kept) {
  ServiceStatus status;
  if (kept.channel == "SERVICE_STATUS" && decode(kept, status) && pids_.count(status.pid) > 0) {
    if (spoken_.insert(status.pid).second) sessions_[status.name].insert(status.session);
    if (own_session(status.name, status.session)) statuses_[status.name] = {kept.t, status};
  }
  SimTruth truth;
  if (kept.channel == "SIM_TRUTH" && decode(kept, truth) && own_session("simulator", truth.session)) truth_ = truth;
  SimBaseTruth base;
  if (kept.channel == "SIM_BASE_TRUTH" && decode(kept, base) && own_session("simulator", base.session))
    base_truth_ = base;
  TaskState task;
  if (kept.channel == "TASK_STATE" && decode(kept, task) && own_session("task-manager", task.session))
    task_state_ = task;
  StopState stop;
  if (kept.channel == "STOP_STATE" && decode(kept, stop) && own_session("simulator", stop.session)) {
    stop_states_[stop.device] = stop;
  }
}

void Bench::sample_processes() {
  sampled_ = now();
  processes_ = stack_processes(folders_.runtime, services());
  for (const auto& [service, found] : processes_) {
    for (const ServiceProcess& process : found) {
      pids_.insert(process.pid);
      fact({{"kind", "process"},
            {"service", service},
            {"pid", process.pid},
            {"state", std::string(1, process.state)},
            {"rss_mb", process.rss_mb}});
    }
  }
}

int Bench::pid_of(const std::string& service) {
  sample_processes();
  const auto found = processes_.find(service);
  return found == processes_.end() || found->second.empty() ? 0 : found->second.back().pid;
}

bool Bench::send(const std::string& channel, const Bytes& data) {
  const std::int64_t t = now();
  history_.sent(t, channel, data);
  own_.emplace_back(t, hash_of(channel, static_cast<std::int64_t>(data.size()), data.data(), data.size()));
  return bus_.send(channel, data);
}

std::unique_ptr<Child> Bench::start(const std::string& name, const std::vector<std::string>& command) {
  const std::string log = folders_.out + "/printed/" + name;
  return std::make_unique<Child>(command, log);
}

int Bench::run(const std::string& name, const std::vector<std::string>& command, double patience_s) {
  const auto child = start(name, command);
  if (!listen(patience_s, [&] { return child->ended(); })) return 124;
  return child->exit_code();
}

std::string Bench::printed(const std::string& name) const {
  std::ostringstream text;
  text << std::ifstream(folders_.out + "/printed/" + name, std::ios::binary).rdbuf();
  return text.str();
}

std::vector<std::string> Bench::stack_command(const std::string& action, const std::vector<std::string>& more) const {
  std::vector<std::string> words{folders_.repository + "/scripts/stack", action, "--runtime-dir", folders_.runtime};
  words.insert(words.end(), more.begin(), more.end());
  return words;
}

std::set<std::string> Bench::ready(double age) const {
  std::set<std::string> ready;
  for (const auto& [service, heard] : statuses_) {
    if (seconds_between(heard.first, now()) <= age && is_ready(heard.second.state)) ready.insert(service);
  }
  return ready;
}

const KeptMessage* Bench::last_heard(const std::string& channel) const {
  const auto found = last_.find(channel);
  return found == last_.end() ? nullptr : &found->second;
}

std::int64_t Bench::heard_count(const std::string& channel) const {
  const auto found = counts_.find(channel);
  return found == counts_.end() ? 0 : found->second;
}

bool Bench::own_session(const std::string& service, std::int64_t session) const {
  const auto found = sessions_.find(service);
  return found != sessions_.end() && found->second.count(session) > 0;
}

}  // namespace markservo::campaign
