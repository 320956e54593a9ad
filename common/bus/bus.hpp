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
// may throw, which counts the message as refused. A network that comes and goes is waited for, and what is not heard is
// told in SERVICE_STATUS (need()).

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <markservo/channels.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/bus_unavailable.hpp"
#include "common/bus/bus_url.hpp"
#include "common/bus/health.hpp"
#include "common/bus/heard_bytes.hpp"
#include "common/bus/publisher.hpp"
#include "common/bus/raw_subscription.hpp"
#include "common/bus/service_health.hpp"
#include "common/bus/subscription.hpp"
#include "common/bus/time_line.hpp"
#include "common/bus/timers.hpp"

namespace lcm {
class LCM;
struct ReceiveBuffer;
}  // namespace lcm
namespace markservo {
class ServiceStatus;
}

namespace markservo::bus {

class Network;

// How many messages wait while nobody polls; beyond them liblcm drops.
struct WaitingMessages {
  int large = 0;  // of the table's large channels: a picture pair is 2 MB
  int small = 0;  // of all others
};

// How long a channel that is needed may be silent, s: above the pauses of a busy machine and of a service that is
// restarted, and well below the 5 s after which nobody may call a deaf service ready.
inline constexpr double kNeededWithin = 3.0;

struct BusParameters {
  BusUrls urls;
  std::string service_name;      // as in SERVICE_STATUS
  std::string robot;             // prefixes all channels with "robot/" when not empty
  std::int64_t config_hash = 0;  // of all settings in force
  bool source = false;           // reads nothing and writes a log: the same session in every run
  bool heartbeat = true;         // SERVICE_STATUS; never written to file://
  // A service waits for a route, an interface or a server that is missing; a tool ends.
  bool waits_for_network = false;
};

class Bus final : private SubscriptionHost, private MessageSink {
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
  // All channels (of the robot), as bytes, in the order in which they come, each message once: only for who shows them.
  // Messages of this kind are not counted in SERVICE_STATUS, nor is a writer's time taken from them. What `handler`
  // throws is complained of. A poll then ends after some 10 ms though messages wait: descriptor() stays readable.
  void on_all(WaitingMessages most, std::function<void(const HeardBytes& message)> handler);
  // Sends bytes as they are. False if the network refused them, which is counted.
  bool publish_raw(const std::string& channel, const void* data, std::size_t size);

  template <class M>
  Publisher<M> advertise(const channels::Channel<M>& channel) {
    advertised_.emplace_back(channel.name);
    MessageSink* sink = this;  // a private base: only here is the conversion allowed
    return Publisher<M>(sink, full_channel(channel.name), session_);
  }

  // Calls `task` every `period` of this host's steady clock while the bus is live; never while a log is replayed.
  void every(std::chrono::milliseconds period, std::function<void()> task);

  // Says that the service cannot work without `channel`, which it has subscribed: SERVICE_STATUS then says `waiting`
  // until it is heard, and `stale` when nothing was accepted for `within` seconds of this host's clock. Throws
  // std::logic_error for a channel that is not subscribed.
  void need(const channels::Entry& channel, double within = kNeededWithin);

  // Counts what `other` hears in this service's SERVICE_STATUS too, each channel with `prefix`. `other` must outlive
  // this.
  void report_also(const Bus& other, std::string prefix);

  // How the service says it is; published at once when that changes. While the bus knows of something that keeps the
  // service from its work (need(), the network), SERVICE_STATUS says that, and the service's own state again
  // afterwards.
  void set_state(const std::string& state, const std::string& reason = {});
  // The service's own.
  const std::string& state() const { return health_.own().state; }

  // Handles what comes within `timeout`, then the timers. False once the service shall end: SIGINT, SIGTERM, stop(), or
  // the end of the log.
  bool poll(std::chrono::milliseconds timeout);
  void spin() {
    while (poll(std::chrono::milliseconds(200))) {
    }
  }
  void stop() { stopped_ = true; }
  // Ends a log that is written in place of a bus. Throws LogNotWritten unless all that was published is in it.
  void finish();
  // Readable when messages wait: for who waits on more than this bus, with poll(2), and then calls poll(0).
  // Another one after the network was gone, though its number may be the same (openings()); -1 while it is.
  int descriptor() const;
  // How often what is heard was opened: grows when descriptor() is another one.
  int openings() const;

  // The newest utime on any subscribed channel, us: what "now" means to the algorithms; 0 before the first message.
  std::int64_t newest_utime() const override { return time_line_.newest(); }
  // Nothing is live about a log.
  bool replaying() const override;
  std::int64_t session() const { return session_; }
  const BusUrls& urls() const { return parameters_.urls; }
  // The prefix of all channels, empty for none.
  const std::string& robot() const { return parameters_.robot; }
  // The channels advertised, in that order, without the prefix.
  const std::vector<std::string>& advertised() const { return advertised_; }
  // What SERVICE_STATUS says now.
  ServiceStatus status() const;

 private:
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
  bool send(const Outgoing& message) override;
  std::int64_t event_time(const Outgoing& message) const;
  void subscribe_all(lcm::LCM& lcm);
  void subscribe_to_everything(lcm::LCM& lcm);
  static void receive_any(const lcm::ReceiveBuffer* buffer, const std::string& channel, Bus* bus);
  bool handle_incoming(std::chrono::milliseconds timeout);
  void look_after_health();
  void tell(const Health& health);
  std::optional<Health> network_health() const;
  std::optional<Health> inputs_health() const;
  void add_counters(const std::string& prefix, ServiceStatus& status) const;
  void publish_status();
  void run_timers();
  std::chrono::milliseconds until_next_timer(std::chrono::milliseconds limit) const;

  void note_traffic() override;
  bool note_utime(std::int64_t utime) override;
  double ahead_of_clock(std::int64_t utime) const override;
  void complain(const std::string& channel, const std::string& what) override;

  BusParameters parameters_;
  std::unique_ptr<Network> network_;
  std::int64_t session_ = 0;
  std::vector<std::unique_ptr<Subscription>> subscriptions_;
  std::function<void(const HeardBytes& message)> on_all_;
  WaitingMessages on_all_most_;
  std::vector<std::string> advertised_;
  std::vector<std::pair<const Bus*, std::string>> reported_also_;  // with their channels' prefix
  Timers timers_;
  std::unique_ptr<Publisher<ServiceStatus>> status_publisher_;
  ServiceHealth health_;
  TimeLine time_line_;
  bool stopped_ = false;
  std::map<std::string, std::chrono::steady_clock::time_point> last_complaint_;
};

}  // namespace markservo::bus
