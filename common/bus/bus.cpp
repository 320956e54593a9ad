#include "common/bus/bus.hpp"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <markservo/ServiceStatus.hpp>
#include <utility>

#include "common/bus/end_signals.hpp"
#include "common/bus/host_name.hpp"
#include "common/bus/network_check.hpp"
#include "common/bus/session.hpp"
#include "common/time/clocks.hpp"

namespace markservo::bus {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr int64_t kClockTolerance_us = 20'000;      // hosts' clocks agree within 5 ms; this far ahead is wrong
constexpr int64_t kTimelineRestart_us = 1'000'000;  // a writer that restarts this far back begins a new time line
constexpr milliseconds kHeartbeat{1000};
constexpr int kMaxDrain = 4096;  // messages per poll, so that a flood cannot starve the timers

// LCM takes channels as regular expressions, anchored at both ends.
std::string escape(const std::string& literal) {
  std::string regex;
  for (const char character : literal) {
    if (std::string("\\^$.|?*+()[]{}").find(character) != std::string::npos) regex += '\\';
    regex += character;
  }
  return regex;
}

std::shared_ptr<lcm::LCM> connect(const std::string& url) {
  if (is_file(url) && url.find("mode=w") == std::string::npos && access(file_path(url).c_str(), R_OK) != 0) {
    throw BusUnavailable("bus " + url + ": the log cannot be read; allowed: an existing LCM log");
  }
  auto lcm = std::make_shared<lcm::LCM>(url);
  if (!lcm->good()) {
    throw BusUnavailable("bus " + url + ": cannot be joined; " +
                         (is_udpm(url) ? multicast_route_advice() : "allowed: udpm://, memq:// or file:// URLs"));
  }
  return lcm;
}

void raw_handler(const lcm::ReceiveBuffer* buffer, const std::string& /*channel*/, Subscription* subscription) {
  subscription->receive(buffer->data, buffer->data_size);
}

}  // namespace

Bus::Bus(BusParameters parameters) : parameters_(std::move(parameters)) {
  const BusUrls& urls = parameters_.urls;
  replaying_ = is_file(urls.in) && urls.in.find("mode=w") == std::string::npos;
  session_ = random_session();
  if (parameters_.source) session_ = source_session(parameters_.service_name);
  if (replaying_) session_ = replay_session(file_path(urls.in), parameters_.service_name);
  in_ = connect(urls.in);
  out_ = urls.out == urls.in ? in_ : connect(urls.out);
  if (parameters_.heartbeat && !is_file(urls.out)) {
    status_publisher_ = std::make_unique<Publisher<ServiceStatus>>(advertise(channels::kServiceStatus));
    every(kHeartbeat, [this] { publish_status(); });
  }
  note_end_signals();
}

Bus::~Bus() = default;

std::string Bus::full_channel(const std::string& channel) const {
  return parameters_.robot.empty() ? channel : parameters_.robot + "/" + channel;
}

void Bus::attach(std::unique_ptr<Subscription> subscription) {
  in_->subscribeFunction(escape(subscription->channel()), raw_handler, subscription.get());
  subscriptions_.push_back(std::move(subscription));
}

void Bus::on_raw(const std::string& channel, RawSubscription::Handler handler) {
  SubscriptionHost* host = this;  // a private base: only here is the conversion allowed
  attach(std::make_unique<RawSubscription>(host, full_channel(channel), std::move(handler)));
}

void Bus::publish_raw(const std::string& channel, const void* data, std::size_t size) {
  if (out_->publish(full_channel(channel), data, static_cast<unsigned int>(size)) < 0) {
    throw std::runtime_error("publish on " + channel + ": the bus refused the message");
  }
}

void Bus::every(milliseconds period, std::function<void()> task) {
  timers_.push_back({period, steady_clock::now() + period, std::move(task)});
}

milliseconds Bus::until_next_timer(milliseconds limit) const {
  milliseconds wait = limit;
  if (replaying_) return wait;
  const auto now = steady_clock::now();
  for (const auto& timer : timers_) {
    wait = std::min(wait, std::chrono::ceil<milliseconds>(std::max(timer.due - now, steady_clock::duration::zero())));
  }
  return wait;
}

void Bus::run_timers() {
  if (replaying_) return;
  const auto now = steady_clock::now();
  for (auto& timer : timers_) {
    if (timer.due > now) continue;
    timer.due = now + timer.period;
    try {
      timer.task();
    } catch (const std::exception& error) {
      complain("timer", error.what());
    }
  }
}

bool Bus::poll(milliseconds timeout) {
  if (stopped_ || told_to_end()) return false;
  errno = 0;
  int handled = in_->handleTimeout(static_cast<int>(until_next_timer(timeout).count()));
  if (handled < 0 && (replaying_ || told_to_end())) return false;  // the end of the log, or told to stop
  if (handled < 0 && errno != EINTR) throw BusUnavailable("bus " + parameters_.urls.in + ": cannot be read any more");
  if (!replaying_) {
    for (int count = 1; handled > 0 && count < kMaxDrain; ++count) handled = in_->handleTimeout(0);
  }
  for (const auto& subscription : subscriptions_) subscription->dispatch();
  run_timers();
  return !stopped_ && !told_to_end();
}

void Bus::set_state(const std::string& state, const std::string& reason) {
  if (state == state_ && reason == reason_) return;
  state_ = state;
  reason_ = reason;
  if (!status_publisher_) return;
  try {
    publish_status();
  } catch (const std::exception& error) {
    complain(channels::kServiceStatus.name, error.what());
  }
}

ServiceStatus Bus::status() const {
  ServiceStatus status{};
  status.utime = wall_clock_us();
  status.name = parameters_.service_name;
  status.host = host_name();
  status.pid = getpid();
  status.version = MARKSERVO_VERSION;
  status.config_hash = parameters_.config_hash;
  status.state = state_;
  status.reason = reason_;
  add_counters("", status);
  for (const auto& [other, prefix] : reported_also_) other->add_counters(prefix, status);
  status.num_channels = static_cast<int32_t>(status.channels.size());
  return status;
}

void Bus::add_counters(const std::string& prefix, ServiceStatus& status) const {
  for (const auto& subscription : subscriptions_) {
    const ChannelCounters& counters = subscription->counters();
    ChannelStatus channel{};
    channel.channel = prefix + subscription->channel();
    channel.received = counters.received;
    channel.skipped = counters.skipped;
    channel.lost = counters.sequence.lost();
    channel.decode_failures = counters.decode_failures;
    channel.refused = counters.refused;
    channel.second_writer = counters.sequence.second_writer() ? 1 : 0;
    channel.age = counters.newest_utime < 0 ? -1.0 : 1e-6 * static_cast<double>(newest_utime_ - counters.newest_utime);
    channel.latency_p50 = counters.latency.percentile(0.50);
    channel.latency_p99 = counters.latency.percentile(0.99);
    status.channels.push_back(std::move(channel));
  }
}

void Bus::report_also(const Bus& other, std::string prefix) {
  reported_also_.emplace_back(&other, std::move(prefix));
}

void Bus::publish_status() {
  ServiceStatus message = status();
  status_publisher_->publish(message);
}

void Bus::note_utime(int64_t utime, bool new_session) {
  const bool restarted = new_session && utime < newest_utime_ - kTimelineRestart_us;
  newest_utime_ = restarted ? utime : std::max(newest_utime_, utime);
}

bool Bus::from_the_future(int64_t utime) const {
  return !replaying_ && utime > wall_clock_us() + kClockTolerance_us;
}

void Bus::complain(const std::string& channel, const std::string& what) {
  const auto now = steady_clock::now();
  const auto last = last_complaint_.find(channel);
  if (last != last_complaint_.end() && now - last->second < std::chrono::seconds(1)) return;
  last_complaint_[channel] = now;
  spdlog::warn("{}: message dropped: {}", channel, what);
}

}  // namespace markservo::bus
