// Faults that speak: a second writer, late and doubled messages, values and texts at their extremes.

#include <algorithm>
#include <cmath>
#include <limits>

#include "common/bus/session.hpp"
#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/message_craft.hpp"
#include "tests/system/fault_campaign/random.hpp"
#include "tests/system/fault_campaign/speaking_fault.hpp"

namespace markservo::campaign {
namespace {

using reflection::Kind;

// A program of its own that also writes a channel.
class SecondWriter : public SpeakingFault {
 public:
  using SpeakingFault::SpeakingFault;

  std::string describe() const override {
    return text("a second writer of %s, %s session, %.0f a second for %.1f s", plan().channel.c_str(),
                plan().same_session ? "the same" : "another", plan().rate, plan().duration);
  }
  void tick(Bench& bench) override {
    for (int i = due(plan().rate); i > 0; --i) speak(bench);
  }

 private:
  void speak(Bench& bench) {
    auto message = sample_for(bench, plan().channel);
    if (!message) return;
    if (const auto utime = get_integer(*message, "utime")) {
      if (plan().channel != "SERVICE_STATUS") shift_stamps(*message, world_now(bench) - *utime);
    }
    ++number_;
    if (!plan().same_session) {
      set_integer(*message, "session", session_);
      set_integer(*message, "seq", number_);
    } else {
      set_integer(*message, "seq", get_integer(*message, "seq").value_or(0) + number_);
    }
    // One goal, request or command, repeated as it must be.
    for (const char* id : {"goal_id", "request_id", "command_id"}) set_integer(*message, id, 7);
    if (plan().channel == "STOP_STATE") set_integer(*message, "latched", 0);
    displace(*message, plan().amount);
    send(bench, plan().channel, *message);
  }

  std::int64_t session_ = bus::random_session();
  std::int64_t number_ = 0;
};

// Some messages come once more, a little later: unchanged.
class LateCopies : public SpeakingFault {
 public:
  using SpeakingFault::SpeakingFault;

  std::string describe() const override {
    return text("%.0f%% of %s once more, %.0f ms late, for %.1f s", plan().percent, plan().channel.c_str(),
                1e3 * plan().delay, plan().duration);
  }
  void strike(Bench& bench) override {
    SpeakingFault::strike(bench);
    bench.add_listener([this](const KeptMessage& kept, bool own) {
      if (running_ && !own && kept.channel == plan().channel && random_.chance(0.01 * plan().percent))
        waiting_.push_back(kept);
    });
    running_ = true;
  }
  void tick(Bench& bench) override {
    while (!waiting_.empty() && seconds_between(waiting_.front().t, Bench::now()) >= plan().delay) {
      send(bench, plan().channel, waiting_.front().data);
      waiting_.pop_front();
    }
  }
  void end(Bench& bench) override {
    running_ = false;
    SpeakingFault::end(bench);
  }

 private:
  bool running_ = false;
  Random random_{7};
  std::deque<KeptMessage> waiting_;
};

// Each value of a message at its extremes, one after the other.
class Extremes : public SpeakingFault {
 public:
  using SpeakingFault::SpeakingFault;

  std::string describe() const override {
    return text("each field of %s at its extremes, %s session, for %.1f s", plan().channel.c_str(),
                plan().same_session ? "the same" : "another", plan().duration);
  }
  void tick(Bench& bench) override {
    for (int i = due(plan().rate); i > 0; --i) speak(bench);
  }

 private:
  void speak(Bench& bench) {
    auto message = sample_for(bench, plan().channel);
    if (!message) return;
    if (!plan().same_session) set_integer(*message, "session", session_);
    const auto leaves = leaf_spans(reflection::TypeCatalog::ours(), *message);
    if (leaves.empty()) return;
    const LeafSpan& leaf = leaves[number_ % leaves.size()];
    const std::size_t extreme = number_ / leaves.size();
    ++number_;
    if (leaf.kind == Kind::kString) {
      static const std::vector<std::string> kTexts = {"",
                                                      "\x1b[2J\x07",
                                                      "line\nFORGED line",
                                                      std::string(2000, 'x'),
                                                      "\xff\xfe",
                                                      "\xe2\x80\xae"
                                                      "drawkcab",
                                                      "\xc2\x9b"
                                                      "31m"};
      put_text(*message, leaf, kTexts[extreme % kTexts.size()]);
    } else if (leaf.kind == Kind::kDouble || leaf.kind == Kind::kFloat) {
      constexpr double kInfinity = std::numeric_limits<double>::infinity();
      static const std::vector<double> kReals = {std::nan(""), kInfinity, -kInfinity, 1e308, -1e308, 0.0, 9e3, -1.0};
      put_real(*message, leaf, kReals[extreme % kReals.size()]);
    } else {
      static const std::vector<std::int64_t> kIntegers = {std::numeric_limits<std::int64_t>::max(),
                                                          std::numeric_limits<std::int64_t>::min(),
                                                          0,
                                                          -1,
                                                          1,
                                                          127,
                                                          0x7fffffff};
      put_integer(*message, leaf, kIntegers[extreme % kIntegers.size()]);
    }
    send(bench, plan().channel, *message);
  }

  std::int64_t session_ = bus::random_session();
  std::size_t number_ = 0;
};

// A text as no person would write it: long, and full of what commands a terminal.
class LongText : public SpeakingFault {
 public:
  using SpeakingFault::SpeakingFault;

  std::string describe() const override {
    return text("a text of %.0f bytes with control characters on %s, %s session", plan().amount, plan().channel.c_str(),
                plan().same_session ? "the same" : "another");
  }
  void tick(Bench& bench) override {
    for (int i = due(plan().rate); i > 0; --i) {
      auto message = sample_for(bench, plan().channel);
      if (!message) return;
      if (!plan().same_session) set_integer(*message, "session", session_);
      std::string words =
          "\x1b[31mred\x07\nFORGED line\r\xc2\x9b"
          "2J\xe2\x80\xae";
      words.resize(std::max(words.size(), static_cast<std::size_t>(plan().amount)), 'x');
      // The last of its texts: the reason, where there is one.
      const auto leaves = leaf_spans(reflection::TypeCatalog::ours(), *message);
      const auto last =
          std::find_if(leaves.rbegin(), leaves.rend(), [](const LeafSpan& leaf) { return leaf.kind == Kind::kString; });
      if (last == leaves.rend()) return;
      put_text(*message, *last, words);
      send(bench, plan().channel, *message);
    }
  }

 private:
  std::int64_t session_ = bus::random_session();
};

}  // namespace

std::unique_ptr<Fault> make_writer_fault(const FaultPlan& plan) {
  if (plan.kind == "second-writer") return std::make_unique<SecondWriter>(plan);
  if (plan.kind == "late-copies") return std::make_unique<LateCopies>(plan);
  if (plan.kind == "extremes") return std::make_unique<Extremes>(plan);
  if (plan.kind == "text") return std::make_unique<LongText>(plan);
  return nullptr;
}

}  // namespace markservo::campaign
