// Faults of time: messages that a relay brings late, in another order or not at all, clocks that are set or drift.

#include <algorithm>
#include <map>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/fault.hpp"
#include "tests/system/fault_campaign/message_craft.hpp"
#include "tests/system/fault_campaign/random.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

constexpr std::uint16_t kRelayPort = kPort + 1;

std::string relay_url() {
  return text("udpm://239.255.76.67:%d?ttl=0", static_cast<int>(kRelayPort));
}

// All that one service hears comes through the trial.
class Relay : public Fault {
 public:
  using Fault::Fault;
  std::string describe() const override {
    return text("%.0f%% of what %s hears is %s (%.0f ms) for %.1f s", plan().percent, plan().service.c_str(),
                plan().variant.c_str(), 1e3 * plan().delay, plan().duration);
  }
  std::set<std::string> words() const override {
    auto words = words_of_service(plan().service);
    words.merge(words_heard_by(plan().service));
    return words;
  }
  void prepare(Bench& bench, StackSetup& setup) override {
    setup.arguments.insert(setup.arguments.end(), {"--args", plan().service, "--lcm-in " + relay_url()});
    bench.add_listener([this](const KeptMessage& message, bool) { pass(message); });
  }
  void strike(Bench&) override { running_ = true; }
  void attend(Bench&) override { deliver(); }
  void end(Bench&) override { running_ = false; }
  std::string evidence() const override { return changed_ > 0 ? text("%d messages", changed_) : ""; }

 private:
  struct Waiting {
    std::int64_t due;
    std::string channel;
    Bytes data;
  };

  void pass(const KeptMessage& message) {
    const bool chosen = running_ && random_.chance(0.01 * plan().percent);
    changed_ += chosen ? 1 : 0;
    if (chosen && plan().variant == "lost") return;
    std::int64_t due = Bench::now();
    if (chosen) due += static_cast<std::int64_t>(plan().delay * 1e6);
    // A slow way keeps the order; another one is what comes apart on the way.
    if (plan().variant == "late") due = last_due_ = std::max(due, last_due_);
    waiting_.push_back({due, message.channel, message.data});
    deliver();
  }
  void deliver() {
    const std::int64_t now = Bench::now();
    for (auto one = waiting_.begin(); one != waiting_.end();) {
      if (one->due > now) {
        ++one;
        continue;
      }
      relay_.send(one->channel, one->data);
      one = waiting_.erase(one);
    }
  }

  MulticastBus relay_{kRelayPort};
  std::deque<Waiting> waiting_;
  std::int64_t last_due_ = 0;
  Random random_{11};
  bool running_ = false;
  int changed_ = 0;
};

// All that one service writes goes through the trial, which sets its stamps.
class SteppedStamps : public Fault {
 public:
  using Fault::Fault;
  std::string describe() const override {
    return text("what %s writes is stamped %+.0f s off for %.1f s", plan().service.c_str(), plan().amount,
                plan().duration);
  }
  std::set<std::string> words() const override { return words_of_service(plan().service); }
  void prepare(Bench&, StackSetup& setup) override {
    setup.arguments.insert(setup.arguments.end(), {"--args", plan().service, "--lcm-out " + relay_url()});
  }
  void strike(Bench&) override { running_ = true; }
  void end(Bench&) override { running_ = false; }
  void attend(Bench& bench) override {
    relay_.receive([&](const HeardMessage& heard) {
      if (static_cast<std::int64_t>(heard.available) != heard.size) return;
      Bytes data(heard.data, heard.data + heard.available);
      if (running_) {
        shift_stamps(data, static_cast<std::int64_t>(plan().amount * 1e6));
        ++changed_;
      }
      bench.pass_on(heard.channel, data);
    });
  }
  std::string evidence() const override { return changed_ > 0 ? text("%d messages", changed_) : ""; }

 private:
  MulticastBus relay_{kRelayPort};
  bool running_ = false;
  int changed_ = 0;
};

// The wall clock of one process, or of all.
class WallClock : public Fault {
 public:
  using Fault::Fault;
  std::string describe() const override {
    return drifts() ? text("the clock of %s goes %.3f times as fast for %.1f s", plan().service.c_str(), plan().amount,
                           plan().duration)
                    : text("the clock of %s is set by %+.0f s for %.1f s", plan().service.c_str(), plan().amount,
                           plan().duration);
  }
  std::set<std::string> words() const override {
    std::set<std::string> words;
    for (const std::string& service : struck()) {
      const auto more = words_of_service(service);
      words.insert(more.begin(), more.end());
    }
    return words;
  }
  void prepare(Bench& bench, StackSetup& setup) override {
    setup.settable_clocks = true;
    bench.add_listener([this](const KeptMessage& message, bool own) {
      if (own || message.channel != "SERVICE_STATUS") return;
      const double off = seconds_between(message.t, get_integer(message.data, "utime").value_or(message.t));
      farthest_ = running_ ? std::max(farthest_, std::abs(off)) : farthest_;
    });
  }
  void strike(Bench& bench) override {
    running_ = true;
    for (const std::string& service : struck())
      set_clock(bench, service, drifts() ? text("+0 x%.3f", plan().amount) : text("%+.0f", plan().amount));
  }
  void end(Bench& bench) override {
    running_ = false;
    for (const std::string& service : struck()) set_clock(bench, service, "+0");
  }
  // SERVICE_STATUS carries its writer's wall clock.
  std::string evidence() const override { return farthest_ > 0.05 ? text("a clock was %.2f s off", farthest_) : ""; }

 private:
  bool drifts() const { return plan().kind == "clock-drift"; }
  std::vector<std::string> struck() const {
    return plan().service == "all" ? Bench::services() : std::vector<std::string>{plan().service};
  }
  bool running_ = false;
  double farthest_ = 0.0;
};

}  // namespace

std::unique_ptr<Fault> make_clock_fault(const FaultPlan& plan) {
  if (plan.kind == "relay") return std::make_unique<Relay>(plan);
  if (plan.kind == "clock-step" && plan.variant == "stamps") return std::make_unique<SteppedStamps>(plan);
  if (plan.kind == "clock-step" || plan.kind == "clock-drift") return std::make_unique<WallClock>(plan);
  return nullptr;
}

}  // namespace markservo::campaign
