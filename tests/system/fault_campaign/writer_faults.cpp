// Faults that speak: a second writer, old, late and doubled messages, values and texts at their extremes.

#include <algorithm>
#include <cmath>
#include <csignal>
#include <limits>
#include <markservo/StopRequest.hpp>
#include <markservo/TaskCommand.hpp>

#include "common/bus/session.hpp"
#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/fault.hpp"
#include "tests/system/fault_campaign/message_craft.hpp"
#include "tests/system/fault_campaign/random.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

using reflection::Kind;

// Counts what it sends; it struck when some of that was heard on the bus.
class SpeakingFault : public Fault {
 public:
  using Fault::Fault;

  std::set<std::string> words() const override { return words_of_channel(plan().channel); }
  void strike(Bench& bench) override {
    heard_before_ = bench.own_heard();
    next_ = Bench::now();
  }
  void end(Bench& bench) override { heard_ = bench.own_heard() - heard_before_; }
  std::string evidence() const override {
    return sent_ > 0 && heard_ > 0
               ? text("%ld sent, %ld heard on the bus", static_cast<long>(sent_), static_cast<long>(heard_))
               : "";
  }

 protected:
  void send(Bench& bench, const std::string& channel, const Bytes& data) {
    bench.send(channel, data);
    ++sent_;
  }
  // How many are due by now at `rate`.
  int due(double rate) {
    int count = 0;
    for (; next_ <= Bench::now() && count < 20; ++count) next_ += static_cast<std::int64_t>(1e6 / rate);
    return count;
  }

 private:
  std::int64_t sent_ = 0;
  std::int64_t heard_before_ = 0;
  std::int64_t heard_ = 0;
  std::int64_t next_ = 0;
};

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

// What was said before is said again, long after.
class OldMessages : public SpeakingFault {
 public:
  using SpeakingFault::SpeakingFault;

  std::string describe() const override {
    return text("messages %.0f s old on %s, into %s processes", plan().amount,
                plan().channel == "all" ? "all channels" : plan().channel.c_str(), plan().variant.c_str());
  }
  std::set<std::string> words() const override {
    if (plan().channel != "all") return words_of_channel(plan().channel);
    return {"STOP",         "stop",  "latched",      "JOINT_STATE", "STOP_STATE",
            "TASK_COMMAND", "abort", "SERVO_STATUS", "restarted"};
  }
  void strike(Bench& bench) override {
    SpeakingFault::strike(bench);
    choose(bench);
    if (plan().variant == "fresh") {
      for (const std::string& service : Bench::services()) {
        if (const int pid = bench.pid_of(service)) ::kill(pid, SIGKILL);
      }
    } else if (plan().variant == "latched") {
      StopRequest stop{};
      stop.kind = StopRequest::STOP;
      stop.utime = world_now(bench);
      stop.session = bus::random_session();
      stop.request_id = 1;
      stop.source = "campaign";
      stop.reason = "STOP before old messages are played";
      bench.send("STOP", encoded(stop));
    }
    began_ = plan().variant == "fresh" ? 0 : Bench::now() + 500'000;
    stop_states_ = bench.heard_count("STOP_STATE");
    prepare_script();
  }
  void tick(Bench& bench) override {
    // Into fresh processes once the robot speaks again.
    if (began_ == 0 && bench.heard_count("STOP_STATE") > stop_states_ + 2) began_ = Bench::now();
    while (began_ > 0 && at_ < script_.size() && seconds_between(began_, Bench::now()) >= due_[at_]) {
      send(bench, script_[at_].channel, script_[at_].data);
      ++at_;
    }
  }

 private:
  void choose(Bench& bench) {
    bool started = false;
    for (const KeptMessage& kept : bench.kept()) {
      const bool command = kept.channel == "STOP" || kept.channel == "TASK_COMMAND";
      const bool chosen = plan().channel == "all" ? kept.channel.rfind("SIM_", 0) != 0 : kept.channel == plan().channel;
      // A person's few words are always among them: they are what must not count again.
      if (chosen || command) script_.push_back(kept);
      started = started || kept.channel == "TASK_COMMAND";
    }
    if (started) return;
    TaskCommand start{};
    start.kind = TaskCommand::START;
    start.utime = bench.task().utime;
    start.session = bus::random_session();
    start.command_id = 1;
    start.target = "red_book";
    script_.push_back({Bench::now(), "TASK_COMMAND", encoded(start)});
  }
  void prepare_script() {
    // The whole fits into the fault's time.
    constexpr std::size_t kMost = 1500;
    if (script_.size() > kMost) {
      std::vector<KeptMessage> kept;
      for (const KeptMessage& one : script_) {
        const bool command = one.channel == "STOP" || one.channel == "TASK_COMMAND";
        if (command || &one - script_.data() >= static_cast<std::ptrdiff_t>(script_.size() - kMost))
          kept.push_back(one);
      }
      script_ = kept;
    }
    const auto shift = static_cast<std::int64_t>(-plan().amount * 1e6);
    for (KeptMessage& one : script_) {
      shift_stamps(one.data, shift);
      // Another run's sessions.
      for (const char* name : {"session", "goal_session", "request_session", "command_session"}) {
        const auto session = get_integer(one.data, name);
        if (session && *session != 0) set_integer(one.data, name, *session ^ 0x5a5a5a5a);
      }
    }
    const double room = std::max(0.5, plan().duration - 1.5);
    for (std::size_t i = 0; i < script_.size(); ++i) {
      due_.push_back(room * static_cast<double>(i) / static_cast<double>(script_.size()));
    }
  }

  std::vector<KeptMessage> script_;
  std::vector<double> due_;  // s after the strike
  std::size_t at_ = 0;
  std::int64_t began_ = 0;  // us; 0: not yet
  std::int64_t stop_states_ = 0;
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
  if (plan.kind == "old-messages") return std::make_unique<OldMessages>(plan);
  if (plan.kind == "late-copies") return std::make_unique<LateCopies>(plan);
  if (plan.kind == "extremes") return std::make_unique<Extremes>(plan);
  if (plan.kind == "text") return std::make_unique<LongText>(plan);
  return nullptr;
}

}  // namespace markservo::campaign
