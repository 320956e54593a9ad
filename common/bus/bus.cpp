#include "common/bus/bus.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <lcm/lcm-cpp.hpp>
#include <markservo/ServiceStatus.hpp>
#include <stdexcept>
#include <thread>
#include <utility>

#include "common/bus/channel_expressions.hpp"
#include "common/bus/clock_tolerance.hpp"
#include "common/bus/end_signals.hpp"
#include "common/bus/host_name.hpp"
#include "common/bus/log_not_written.hpp"
#include "common/bus/network.hpp"
#include "common/bus/robot_channel.hpp"
#include "common/bus/session.hpp"
#include "common/logging/log.hpp"
#include "common/time/clocks.hpp"

namespace markservo::bus {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kHeartbeat{1000};
constexpr int kMaxDrain = 4096;  // messages per poll, so that a flood cannot starve the timers
// Of who hears all channels: it has clients to serve between. Of nobody else: cut short, "the newest" would be an old
// one.
constexpr milliseconds kLongestDrain{10};
constexpr milliseconds kNoBusNap{50};  // while there is nothing to listen to

void raw_handler(const lcm::ReceiveBuffer* buffer, const std::string& /*channel*/, Subscription* subscription) {
  subscription->receive(buffer->data, buffer->data_size);
}

// A subscription of no content: that something came is all it tells.
class Echo final : public Subscription {
 public:
  using Subscription::Subscription;
  void receive(const void* /*data*/, std::size_t /*size*/) override { note_arrival(); }
  void dispatch() override {}
};

void subscribe_to(lcm::LCM& lcm, Subscription* subscription) {
  lcm.subscribeFunction(expression_of(subscription->channel()), raw_handler, subscription);
}

}  // namespace

Bus::Bus(BusParameters parameters) : parameters_(std::move(parameters)) {
  const BusUrls& urls = parameters_.urls;
  network_ =
      std::make_unique<Network>(urls, parameters_.waits_for_network, [this](lcm::LCM& lcm) { subscribe_all(lcm); });
  session_ = random_session();
  if (parameters_.source) session_ = source_session(parameters_.service_name);
  if (replaying()) session_ = replay_session(file_path(urls.in), parameters_.service_name);
  const bool speaks = parameters_.heartbeat && !is_file(urls.out);
  if (speaks && network_->returns_heartbeats()) {
    SubscriptionHost* host = this;  // a private base: only here is the conversion allowed
    network_->hear_itself_by(std::make_unique<Echo>(host, full_channel(channels::kServiceStatus.name)));
  }
  network_->open();
  look_after_health();
  if (speaks) {
    status_publisher_ = std::make_unique<Publisher<ServiceStatus>>(advertise(channels::kServiceStatus));
    every(kHeartbeat, [this] {
      publish_status();
      network_->note_heartbeat();
    });
  }
  note_end_signals();
}

Bus::~Bus() = default;

std::string Bus::full_channel(const std::string& channel) const {
  return robot_channel(parameters_.robot, channel);
}

void Bus::attach(std::unique_ptr<Subscription> subscription) {
  if (lcm::LCM* lcm = network_->in().lcm()) subscribe_to(*lcm, subscription.get());
  subscriptions_.push_back(std::move(subscription));
}

void Bus::subscribe_all(lcm::LCM& lcm) {
  if (Subscription* echo = network_->echo()) subscribe_to(lcm, echo);
  for (const auto& subscription : subscriptions_) subscribe_to(lcm, subscription.get());
  if (on_all_) subscribe_to_everything(lcm);
}

void Bus::subscribe_to_everything(lcm::LCM& lcm) {
  const AllChannels all = all_channels(parameters_.robot);
  lcm.subscribeFunction(all.large, &Bus::receive_any, this)->setQueueCapacity(on_all_most_.large);
  lcm.subscribeFunction(all.others, &Bus::receive_any, this)->setQueueCapacity(on_all_most_.small);
}

void Bus::receive_any(const lcm::ReceiveBuffer* buffer, const std::string& channel, Bus* bus) {
  bus->note_traffic();
  try {
    bus->on_all_({channel, buffer->data, buffer->data_size, buffer->recv_utime});
  } catch (const std::exception& error) {
    bus->complain(channel, error.what());
  }
}

void Bus::on_all(WaitingMessages most, std::function<void(const HeardBytes& message)> handler) {
  on_all_most_ = most;
  on_all_ = std::move(handler);
  if (lcm::LCM* lcm = network_->in().lcm()) subscribe_to_everything(*lcm);
}

void Bus::on_raw(const std::string& channel, RawSubscription::Handler handler) {
  SubscriptionHost* host = this;  // a private base: only here is the conversion allowed
  attach(std::make_unique<RawSubscription>(host, full_channel(channel), std::move(handler)));
}

bool Bus::publish_raw(const std::string& channel, const void* data, std::size_t size) {
  return send({full_channel(channel), data, size, 0});
}

// What tells no time of its own, a STOP before anything was heard, happens now, as the messages have it.
std::int64_t Bus::event_time(const Outgoing& message) const {
  if (message.utime > 0) return message.utime;
  return newest_utime() > 0 ? newest_utime() : wall_clock_us();
}

bool Bus::send(const Outgoing& message) {
  Connection& out = network_->out();
  if (out.publish({message.channel, message.data, message.size, event_time(message)}, steady_clock::now())) return true;
  const std::string why = out.refused_sends(steady_clock::now()).reason;
  if (is_file(out.url())) {
    stopped_ = true;  // a log with a hole is of no use: nothing more is done for it
    throw LogNotWritten(file_path(out.url()), why);
  }
  // A network comes back, but a tool does not wait.
  if (!parameters_.waits_for_network) {
    throw std::runtime_error("publish on " + message.channel + ": the bus refused the message: " + why);
  }
  return false;
}

void Bus::finish() {
  network_->out().finish();
}

void Bus::every(milliseconds period, std::function<void()> task) {
  timers_.add(period, std::move(task), steady_clock::now());
}

int Bus::descriptor() const {
  return network_->in().descriptor();
}

int Bus::openings() const {
  return network_->in().openings();
}

milliseconds Bus::until_next_timer(milliseconds limit) const {
  return replaying() ? limit : timers_.until_next(limit, steady_clock::now());
}

void Bus::run_timers() {
  if (!replaying()) timers_.run(steady_clock::now(), [this](const char* what) { complain("timer", what); });
}

bool Bus::poll(milliseconds timeout) {
  if (stopped_ || told_to_end()) return false;
  if (!replaying()) network_->mend(steady_clock::now());
  if (!handle_incoming(timeout)) return false;
  for (const auto& subscription : subscriptions_) subscription->dispatch();
  run_timers();
  if (!replaying()) look_after_health();
  return !stopped_ && !told_to_end();
}

bool Bus::handle_incoming(milliseconds timeout) {
  const milliseconds wait = until_next_timer(timeout);
  Connection& in = network_->in();
  if (in.lcm() == nullptr) {
    std::this_thread::sleep_for(std::min(wait, kNoBusNap));
    return true;
  }
  errno = 0;
  int handled = in.handle(wait);
  if (handled < 0 && (replaying() || told_to_end())) return false;  // the end of the log, or told to stop
  if (handled < 0 && errno != EINTR) network_->lose_input("it cannot be read any more", steady_clock::now());
  if (!replaying()) {
    const auto end = on_all_ ? steady_clock::now() + kLongestDrain : steady_clock::time_point::max();
    for (int count = 1; handled > 0 && count < kMaxDrain && steady_clock::now() < end; ++count) {
      handled = in.handle(milliseconds(0));
    }
  }
  return true;
}

ServiceStatus Bus::status() const {
  ServiceStatus status{};
  status.utime = wall_clock_us();
  status.name = parameters_.service_name;
  status.host = host_name();
  status.pid = getpid();
  status.version = MARKSERVO_VERSION;
  status.config_hash = parameters_.config_hash;
  const Health told = told_health(health_.own(), network_health(), inputs_health());
  status.state = told.state;
  status.reason = told.reason;
  add_counters("", status);
  for (const auto& [other, prefix] : reported_also_) other->add_counters(prefix, status);
  status.num_channels = static_cast<std::int32_t>(status.channels.size());
  return status;
}

void Bus::add_counters(const std::string& prefix, ServiceStatus& status) const {
  const auto now = steady_clock::now();
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
    channel.age = counters.newest_utime < 0 ? -1.0 : 1e-6 * static_cast<double>(newest_utime() - counters.newest_utime);
    channel.latency_p50 = counters.latency.percentile(0.50, now);
    channel.latency_p99 = counters.latency.percentile(0.99, now);
    status.channels.push_back(std::move(channel));
  }
}

void Bus::report_also(const Bus& other, std::string prefix) {
  reported_also_.emplace_back(&other, std::move(prefix));
}

bool Bus::replaying() const {
  return network_->replaying();
}

void Bus::note_traffic() {
  network_->note_traffic();
}

bool Bus::note_utime(std::int64_t utime) {
  return time_line_.observe(utime);
}

double Bus::ahead_of_clock(std::int64_t utime) const {
  if (replaying()) return 0.0;
  const std::int64_t ahead = utime - wall_clock_us();
  return ahead > kClockTolerance_us ? 1e-6 * static_cast<double>(ahead) : 0.0;
}

void Bus::complain(const std::string& channel, const std::string& what) {
  const auto now = steady_clock::now();
  const auto last = last_complaint_.find(channel);
  if (last != last_complaint_.end() && now - last->second < std::chrono::seconds(1)) return;
  last_complaint_[channel] = now;
  logging::warn("{}: message dropped: {}", channel, what);
}

}  // namespace markservo::bus
