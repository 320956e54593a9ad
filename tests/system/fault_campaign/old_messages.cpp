// What was said before is said again, long after: a recording played on the live bus.

#include <algorithm>
#include <csignal>
#include <markservo/StopRequest.hpp>
#include <markservo/TaskCommand.hpp>

#include "common/bus/session.hpp"
#include "common/time/seconds_between.hpp"
#include "tests/system/fault_campaign/message_craft.hpp"
#include "tests/system/fault_campaign/speaking_fault.hpp"

namespace markservo::campaign {
namespace {

// What was said before is said again, long after.
class OldMessages : public SpeakingFault {
 public:
  using SpeakingFault::SpeakingFault;

  std::string describe() const override {
    return text("messages %.0f s old on %s, into %s processes", plan().amount,
                plan().channel == "all" ? "all channels" : plan().channel.c_str(), plan().variant.c_str());
  }
  std::set<std::string> words() const override {
    std::set<std::string> words = words_of_channel(plan().channel);
    // A person's few words are played whatever the channel, and all of them when it is all.
    words.insert({"STOP", "TASK_COMMAND", "aborted by operator"});
    if (plan().channel == "all")
      words.insert({"JOINT_STATE", "STOP_STATE", "SERVO_STATUS", "BASE_STATUS", "STEREO_FRAME"});
    if (plan().variant == "fresh") words.insert({"started: no task", "the arm restarted"});
    return words;
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

}  // namespace

std::unique_ptr<Fault> make_old_messages(const FaultPlan& plan) {
  return plan.kind == "old-messages" ? std::make_unique<OldMessages>(plan) : nullptr;
}

}  // namespace markservo::campaign
