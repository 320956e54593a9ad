#pragma once

// The LCM bus as the services use it: typed, checked, counted. One thread; handlers run inside poll().
//
//   bus.on_latest(channels::kStereoFrame, [&](const StereoFrame& frame) { ... });  // last wins
//   bus.on_each(channels::kServoGoal, [&](const ServoGoal& goal) { ... });         // all, in order
//   auto poses = bus.advertise(channels::kTargetPose);
//   poses.publish(pose);                                                           // fills session and seq
//   bus.spin();
//
// Messages that wait are handed over in the order in which their channels were subscribed. A handler may publish; it
// may throw, which counts the message as refused.

#include <chrono>
#include <cstdint>
#include <functional>
#include <lcm/lcm-cpp.hpp>
#include <map>
#include <markservo/channels.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/bus_url.hpp"
#include "common/bus/publisher.hpp"
#include "common/bus/raw_subscription.hpp"
#include "common/bus/subscription.hpp"

namespace markservo {
class ServiceStatus;
}

namespace markservo::bus {

// The bus cannot be joined. Ends a service with exit code 3.
class BusUnavailable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// The state in SERVICE_STATUS of a service that has said nothing of itself yet.
inline constexpr const char* kStarting = "starting";

struct BusParameters {
  BusUrls urls;
  std::string service_name;  // as in SERVICE_STATUS
  std::string robot;         // prefixes all channels with "robot/" when not empty
  int64_t config_hash = 0;   // of all settings in force
  bool source = false;       // reads nothing and writes a log: the same session in every run
  bool heartbeat = true;     // SERVICE_STATUS; never written to file://
};

class Bus final : private SubscriptionHost {
 public:
  // Throws BusUnavailable with a line that says what to do.
  explicit Bus(BusParameters parameters);
  ~Bus() override;
  Bus(const Bus&) = delete;
  Bus& operator=(const Bus&) = delete;

  // Of a channel that many write by design (Second::kAllowed) no loss or second writer is counted.
  template <class M>
  void on_latest(const channels::Channel<M>& channel, typename TypedSubscription<M>::Handler handler) {
    subscribe(channel, Delivery::kLatest, std::move(handler));
  }
  template <class M>
  void on_each(const channels::Channel<M>& channel, typename TypedSubscription<M>::Handler handler) {
    subscribe(channel, Delivery::kEach, std::move(handler));
  }

  // A channel of any type, as bytes that nobody looks into: only for who passes messages on. False counts the message
  // as skipped; what it throws, as refused.
  void on_raw(const std::string& channel, RawSubscription::Handler handler);
  // Sends bytes as they are. Throws std::runtime_error if the bus refuses.
  void publish_raw(const std::string& channel, const void* data, std::size_t size);

  template <class M>
  Publisher<M> advertise(const channels::Channel<M>& channel) {
    return Publisher<M>(out_.get(), full_channel(channel.name), session_);
  }

  // Calls `task` every `period` of this host's steady clock while the bus is live; never while a log is replayed.
  void every(std::chrono::milliseconds period, std::function<void()> task);

  // Counts what `other` hears in this service's SERVICE_STATUS too, each channel with `prefix`. `other` must outlive
  // this.
  void report_also(const Bus& other, std::string prefix);

  // The service's own word for how it is; published at once when it changes.
  void set_state(const std::string& state, const std::string& reason = {});
  const std::string& state() const { return state_; }

  // Handles what comes within `timeout`, then the timers. False once the service shall end: SIGINT, SIGTERM, stop(), or
  // the end of the log.
  bool poll(std::chrono::milliseconds timeout);
  void spin() {
    while (poll(std::chrono::milliseconds(200))) {
    }
  }
  void stop() { stopped_ = true; }
  // Readable when messages wait: for who waits on more than this bus, with poll(2), and then calls poll(0).
  int descriptor() const { return in_->getFileno(); }

  // The newest utime on any subscribed channel, us: what "now" means to the algorithms; 0 before the first message.
  int64_t newest_utime() const override { return newest_utime_; }
  // Nothing is live about a log.
  bool replaying() const override { return replaying_; }
  int64_t session() const { return session_; }
  const BusUrls& urls() const { return parameters_.urls; }
  // The prefix of all channels, empty for none.
  const std::string& robot() const { return parameters_.robot; }
  // What SERVICE_STATUS says now.
  ServiceStatus status() const;

 private:
  struct Timer {
    std::chrono::milliseconds period;
    std::chrono::steady_clock::time_point due;
    std::function<void()> task;
  };

  template <class M>
  void subscribe(const channels::Channel<M>& channel, Delivery delivery,
                 typename TypedSubscription<M>::Handler handler) {
    SubscriptionHost* host = this;  // a private base: only here is the conversion allowed
    const bool exclusive = channel.second != channels::Second::kAllowed;
    attach(std::make_unique<TypedSubscription<M>>(host, full_channel(channel.name), delivery, exclusive,
                                                  std::move(handler)));
  }
  void attach(std::unique_ptr<Subscription> subscription);
  std::string full_channel(const std::string& channel) const;
  void add_counters(const std::string& prefix, ServiceStatus& status) const;
  void publish_status();
  void run_timers();
  std::chrono::milliseconds until_next_timer(std::chrono::milliseconds limit) const;

  void note_utime(int64_t utime, bool new_session) override;
  bool from_the_future(int64_t utime) const override;
  void complain(const std::string& channel, const std::string& what) override;

  BusParameters parameters_;
  bool replaying_ = false;
  int64_t session_ = 0;
  std::shared_ptr<lcm::LCM> in_;
  std::shared_ptr<lcm::LCM> out_;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  std::vector<std::pair<const Bus*, std::string>> reported_also_;  // with their channels' prefix
  std::vector<Timer> timers_;
  std::unique_ptr<Publisher<ServiceStatus>> status_publisher_;
  std::string state_ = kStarting;
  std::string reason_;
  int64_t newest_utime_ = 0;
  bool stopped_ = false;
  std::map<std::string, std::chrono::steady_clock::time_point> last_complaint_;
};

}  // namespace markservo::bus
