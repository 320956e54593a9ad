#pragma once

// A robot at work as TroubleWatch hears it, in which a test breaks one thing: ten times a second what comes often, once
// a second what services, stack and recorder say of themselves.

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "services/mmi/troubles/trouble_watch.hpp"

namespace markservo::mmi {

class HealthyRobot {
 public:
  static constexpr double kTick = 0.1;  // s

  HealthyRobot() : watch({"arm", "base"}) {
    task = {0, TaskPhase::kServo, TaskResult::kNone, "red_book", ""};
    servo = {0, ServoState::kServo, false, 0.0032, ""};
    base = {0, BaseState::kHold, 0.0, ""};
    pose = {0, LocalisationState::kLocalised, {1.0, 2.0, 0.5}, 0.01, 0.01, ""};
    marks = {0, {{"hand", true, MarkStatus::kLocated}, {"red_book", false, MarkStatus::kLocated}}};
    stops = {{0, "arm", false, true, "operator: asked"}, {0, "base", false, true, "operator: asked"}};
    services = {service("mark-detector", 11), service("visual-servo", 12), service("simulator", 13)};
    services[0].channels = {{"STEREO_FRAME", 0, 0, 0, false}};
    services[1].channels = {{"JOINT_STATE", 0, 0, 0, false}};
    processes = {process("mark-detector", 11), process("visual-servo", 12), process("simulator", 13)};
    recorder = {0, "logs/today", "host", true, 1000, 1000000, 1, ""};
  }

  static ServiceWord service(const std::string& name, int pid) { return {0, pid, name, "host", pid, "ready", "", {}}; }
  static ProcessWord process(const std::string& name, int pid) {
    return {0, name, "host", ProcessState::kRunning, pid, ""};
  }

  // us of the source's clock.
  std::int64_t at() const { return 1'600'000'000'000'000 + std::llround(1e6 * now); }

  // Time passes with all that is said in it; gives the troubles at its end.
  std::vector<Trouble> pass(double seconds) {
    std::vector<Trouble> troubles;
    for (int tick = 0; tick < std::lround(seconds / kTick); ++tick) {
      now += kTick;
      ++ticks_;
      speak();
      troubles = watch.step(now);
    }
    return troubles;
  }

  // Passes until `holds` of the troubles, for `patience` at most; the seconds that it took, and infinity if it never
  // did.
  double until(const std::function<bool(const std::vector<Trouble>&)>& holds, double patience) {
    const double begin = now;
    while (now - begin < patience) {
      if (holds(pass(kTick))) return now - begin;
    }
    return INFINITY;
  }

  // A message of any channel, from the writer of that session.
  void say(const std::string& channel, std::int64_t session, std::int64_t ahead_us = 0, bool one_writes = true,
           const std::string& writer_of = "") {
    watch.observe(AnyWord{at(), channel, writer_of, one_writes, session, at() + ahead_us}, now);
  }

  TroubleWatch watch;
  double now = 100.0;               // s
  std::set<std::string> silent;     // channels, stop devices, services and processes that say nothing
  std::function<void()> each_tick;  // what else is said
  TaskWord task;
  ServoWord servo;
  BaseWord base;
  PoseWord pose;
  MarksWord marks;
  std::vector<StopWord> stops;
  std::vector<ServiceWord> services;
  std::vector<ProcessWord> processes;
  RecorderWord recorder;
  std::int64_t lost_each_second = 0;  // of visual-servo's JOINT_STATE
  std::int64_t clock_ahead_us = 0;    // of the simulator

 private:
  bool speaks(const std::string& name) const { return silent.count(name) == 0; }

  template <class Word>
  void tell(const std::string& name, Word& word) {
    if (!speaks(name)) return;
    word.at = at();
    watch.observe(word, now);
  }

  void speak() {
    if (speaks("STEREO_FRAME")) say("STEREO_FRAME", 13, clock_ahead_us);
    if (speaks("JOINT_STATE")) say("JOINT_STATE", 13, clock_ahead_us);
    tell("TARGET_POSE", marks);
    tell("SERVO_STATUS", servo);
    tell("TASK_STATE", task);
    tell("BASE_STATUS", base);
    tell("ROBOT_POSE", pose);
    for (StopWord& stop : stops) tell(stop.device, stop);
    if (each_tick) each_tick();
    if (ticks_ % 10 == 0) speak_once_a_second();
  }

  void speak_once_a_second() {
    for (ServiceWord& word : services) {
      for (ReceivedWord& channel : word.channels) channel.received += 80;
      if (word.name == "visual-servo") word.channels.front().lost += lost_each_second;
      tell(word.name, word);
    }
    for (ProcessWord& word : processes) tell("PROCESS_STATUS", word);
    tell("RECORDER_STATUS", recorder);
  }

  int ticks_ = 0;
};

inline std::optional<Trouble> of_code(const std::vector<Trouble>& troubles, TroubleCode code) {
  for (const Trouble& trouble : troubles) {
    if (trouble.code == code) return trouble;
  }
  return std::nullopt;
}

// Whether the code is told at any time in `seconds`.
inline bool is_ever_told(HealthyRobot& robot, TroubleCode code, double seconds) {
  const auto told = [&](const std::vector<Trouble>& troubles) { return of_code(troubles, code).has_value(); };
  return std::isfinite(robot.until(told, seconds));
}

}  // namespace markservo::mmi
