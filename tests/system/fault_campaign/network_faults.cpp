// Faults of the network, in the trial's own one: lost and refused packets, no route, no interface, crafted fragments.

#include <cstdlib>

#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/fault.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

class NetworkFault : public Fault {
 public:
  using Fault::Fault;
  // It strikes every channel: whichever is missed first is named, but one must be.
  std::set<std::string> words() const override {
    std::set<std::string> words{"network"};
    for (const std::string& service : Bench::services()) {
      const auto more = words_of_service(service);
      words.insert(more.begin(), more.end());
    }
    return words;
  }

 protected:
  // Runs `ip` or `nft`; whether it could.
  static bool command(Bench& bench, const std::vector<std::string>& words) {
    return bench.run("network", words, 5.0) == 0;
  }
};

// Packets that a filter drops: at the sender, who is told, or at the receiver, who is not.
class Filter : public NetworkFault {
 public:
  using NetworkFault::NetworkFault;
  std::string describe() const override {
    return text("%.0f%% of the packets are %s for %.1f s", plan().percent,
                refusing() ? "refused to their sender" : "lost", plan().duration);
  }
  void strike(Bench& bench) override {
    const std::string hook = refusing() ? "output" : "input";
    set_ = command(
        bench,
        {"nft", text("add table ip campaign%s; add chain ip campaign%s drops { type filter hook %s priority 0; }; "
                     "add counter ip campaign%s dropped; add rule ip campaign%s drops udp dport %d numgen random "
                     "mod 10000 < %d counter name dropped drop",
                     hook.c_str(), hook.c_str(), hook.c_str(), hook.c_str(), hook.c_str(), static_cast<int>(kPort),
                     static_cast<int>(plan().percent * 100.0))});
  }
  void end(Bench& bench) override {
    if (!set_) return;
    const std::string hook = refusing() ? "output" : "input";
    command(bench, {"nft", "list counter ip campaign" + hook + " dropped"});
    const std::string said = bench.printed("network");
    const std::size_t at = said.rfind("packets ");
    if (at != std::string::npos) dropped_ = std::atol(said.c_str() + at + 8);
    command(bench, {"nft", "delete table ip campaign" + hook});
  }
  std::string evidence() const override { return dropped_ > 0 ? text("%ld packets", dropped_) : ""; }

 private:
  bool refusing() const { return plan().kind == "refused-publish"; }
  bool set_ = false;
  long dropped_ = 0;
};

class NoRoute : public NetworkFault {
 public:
  using NetworkFault::NetworkFault;
  std::string describe() const override {
    return text("the %s is gone for %.1f s", interface() ? "interface" : "multicast route", plan().duration);
  }
  void strike(Bench& bench) override {
    gone_ = interface() ? command(bench, {"ip", "link", "set", "lo", "down"})
                        : command(bench, {"ip", "route", "del", "224.0.0.0/4", "dev", "lo"});
    if (!gone_) return;
    const std::int64_t before = bench.refused();
    bench.pass_on("CAMPAIGN_PROBE", {0});
    refused_ = bench.refused() > before;
  }
  void end(Bench& bench) override {
    if (!gone_) return;
    if (interface()) command(bench, {"ip", "link", "set", "lo", "up", "multicast", "on"});
    command(bench, {"ip", "route", "add", "224.0.0.0/4", "dev", "lo"});
  }
  std::string evidence() const override { return refused_ ? "a message was refused" : ""; }

 private:
  bool interface() const { return plan().kind == "interface-gone"; }
  bool gone_ = false;
  bool refused_ = false;
};

// Two datagrams that claim a message's piece to lie far outside of it: liblcm 1.3.1 writes there.
class Fragments : public NetworkFault {
 public:
  using NetworkFault::NetworkFault;
  std::string describe() const override {
    return text("crafted fragments on %s for %.1f s", plan().channel.c_str(), plan().duration);
  }
  void tick(Bench& bench) override {
    if (Bench::now() < next_) return;
    next_ = Bench::now() + (plan().variant == "once" ? 3'600'000'000 : 500'000);
    constexpr std::uint32_t kMessage = 1400;
    constexpr std::uint32_t kOutside = 0xffffff00;
    const std::vector<std::uint8_t> bytes(700, 0x41);
    ++sequence_;
    const bool first = bench.send_datagram(
        fragment_datagram(sequence_, kMessage, 0, 0, 2, plan().channel, bytes.data(), bytes.size()));
    const bool second = bench.send_datagram(
        fragment_datagram(sequence_, kMessage, kOutside, 1, 2, plan().channel, bytes.data(), bytes.size()));
    pairs_ += first && second ? 1 : 0;
  }
  void strike(Bench&) override { next_ = Bench::now(); }
  std::string evidence() const override { return pairs_ > 0 ? text("%d pairs were sent", pairs_) : ""; }

 private:
  std::int64_t next_ = 0;
  std::uint32_t sequence_ = 0x70000000;
  int pairs_ = 0;
};

}  // namespace

std::unique_ptr<Fault> make_network_fault(const FaultPlan& plan) {
  if (plan.kind == "refused-publish" || plan.kind == "loss") return std::make_unique<Filter>(plan);
  if (plan.kind == "route-gone" || plan.kind == "interface-gone") return std::make_unique<NoRoute>(plan);
  if (plan.kind == "fragments") return std::make_unique<Fragments>(plan);
  return nullptr;
}

}  // namespace markservo::campaign
