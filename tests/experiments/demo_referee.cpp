// Runs one task on a simulated robot whose services are up, tells what happens line by line, and judges it by the
// simulator's truth. Used by scripts/demo. Exit code 0 only if the task says lifted and the truth agrees.
//   in:  TASK_STATE, SERVO_STATUS, SIM_TRUTH, STEREO_FRAME, MARK_DETECTION, STEREO_MATCHES, TARGET_POSE, JOINT_COMMAND
//   out: SIM_CONTROL, STOP, TASK_COMMAND; DIR/report.json, DIR/{look,grip,lift}.png

#include <CLI/CLI.hpp>
#include <chrono>
#include <deque>
#include <fstream>
#include <markservo/JointCommand.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/TargetPose.hpp>
#include <nlohmann/json.hpp>
#include <optional>

#include "tests/experiments/demo_pictures.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/experiments/rig.hpp"
#include "tests/experiments/statistics.hpp"
#include "tests/experiments/task_words.hpp"

namespace markservo::experiments {
namespace {

constexpr double kLiftedHeight = 0.020;  // m
constexpr double kLiftedTime = 1.0;      // s
constexpr double kPatience = 120.0;      // s of the world's time, for the whole task

struct DemoOptions {
  std::string target = "red_book";
  bool carry = false;
  bool lockstep = false;
};

double seconds(int64_t utime) {
  return 1e-6 * static_cast<double>(utime);
}

// STEREO_FRAME heard to JOINT_COMMAND heard, by this process's clock.
class CommandLatency {
 public:
  explicit CommandLatency(bus::Bus& bus) {
    bus.on_each<JointCommand>("JOINT_COMMAND", [this](const JointCommand& command) { note(command); });
  }
  void frame(int64_t seq) {
    frames_.emplace_back(seq, std::chrono::steady_clock::now());
    if (frames_.size() > kRemembered) frames_.pop_front();
  }
  const std::vector<double>& milliseconds() const { return milliseconds_; }

 private:
  static constexpr std::size_t kRemembered = 32;
  void note(const JointCommand& command) {
    for (const auto& [seq, when] : frames_) {
      if (seq != command.frame_seq) continue;
      milliseconds_.push_back(
          std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - when).count());
    }
  }
  std::deque<std::pair<int64_t, std::chrono::steady_clock::time_point>> frames_;
  std::vector<double> milliseconds_;
};

// What the task's pictures are made of: the newest frame and its answers.
class Eyes {
 public:
  Eyes(bus::Bus& bus, CommandLatency& latency) {
    bus.on_each<StereoFrame>("STEREO_FRAME", [this, &latency](const StereoFrame& frame) {
      latency.frame(frame.seq);
      frame_ = frame;
    });
    bus.on_each<StereoMatches>("STEREO_MATCHES", [this](const StereoMatches& matches) { matches_ = matches; });
    bus.on_each<TargetPose>("TARGET_POSE", [this](const TargetPose& pose) { pose_ = pose; });
  }
  void write(const std::string& path, const MarkDetection& detection, const std::string& title) const {
    write_annotated_picture(path, frame_, detection, matches_, pose_, title);
  }

 private:
  StereoFrame frame_{};
  StereoMatches matches_{};
  TargetPose pose_{};
};

const SimBody* find_body(const SimTruth& truth, const std::string& name) {
  for (const auto& body : truth.bodies) {
    if (body.name == name) return &body;
  }
  return nullptr;
}

bool held_free(const SimBody& body) {
  return body.height_gain >= kLiftedHeight && body.touches_left_finger && body.touches_right_finger &&
         !body.touches_other;
}

// What the truth says of the lift, frame by frame.
struct LiftWatch {
  double longest = 0.0;  // s, held free without a break
  double highest = 0.0;  // m
  std::optional<int64_t> since;

  void observe(const SimTruth& truth, const std::string& target) {
    const SimBody* body = find_body(truth, target);
    if (body == nullptr) return;
    highest = std::max(highest, body->height_gain);
    if (!held_free(*body)) {
      since.reset();
      return;
    }
    if (!since) since = truth.utime;
    longest = std::max(longest, seconds(truth.utime - *since));
  }
};

// How far the arm moved while no fresh command could have told it to: nothing but rest is safe there.
class StaleMotionWatch {
 public:
  explicit StaleMotionWatch(bus::Bus& bus) {
    bus.on_each<JointCommand>("JOINT_COMMAND", [this](const JointCommand& command) {
      newest_answered_ = std::max(newest_answered_, command.frame_utime);
    });
  }
  void observe(const SimTruth& truth) {
    const bool same_world = truth.session == session_ && shaft_.size() == truth.shaft.size();
    // The arm holds after 0.3 s without a command; what it was told before may take a moment to come to rest.
    const bool stale = truth.utime - newest_answered_ > kStale_us;
    if (same_world && stale && was_stale_) {
      for (std::size_t i = 0; i < shaft_.size(); ++i) moved_ = std::max(moved_, std::abs(truth.shaft[i] - shaft_[i]));
    }
    if (!same_world || !stale || !was_stale_) shaft_ = truth.shaft;
    if (!same_world) newest_answered_ = truth.utime;
    session_ = truth.session;
    was_stale_ = stale;
  }
  double moved() const { return moved_; }

 private:
  static constexpr int64_t kStale_us = 500'000;
  int64_t newest_answered_ = 0;
  int64_t session_ = 0;
  bool was_stale_ = false;
  std::vector<double> shaft_;  // rad, where it was when the input became stale
  double moved_ = 0.0;         // rad
};

struct ServoResult {
  int frames = 0;
  Eigen::Vector3d error = Eigen::Vector3d::Constant(NAN);  // m, true grip point minus true goal, at the end of SERVO
};

Eigen::Vector3d vector(const Vector3& v) {
  return {v.x, v.y, v.z};
}

Eigen::Vector3d grip_error(const SimTruth& truth, const robot::MarkDescription& target) {
  for (const auto& mark : truth.marks) {
    if (mark.name == target.name) return vector(truth.p_CG) - (vector(mark.p_C) + target.grip->p_TG);
  }
  return Eigen::Vector3d::Constant(NAN);
}

struct Course {
  TaskState last;
  double duration = 0.0;  // s of the world's time, START to the task's end
  ServoResult servo;
  LiftWatch lift;
};

bool ended(const TaskState& state, bool carry) {
  // IDLE after START: task-manager was restarted and knows of no task.
  if (state.state == TaskState::IDLE || state.state == TaskState::DONE || state.state == TaskState::REFUSED ||
      state.state == TaskState::FAILED || state.state == TaskState::STOPPED) {
    return true;
  }
  return !carry && state.state == TaskState::HOLD_LIFTED;
}

class Demo {
 public:
  Demo(const ExperimentOptions& options, const DemoOptions& demo, const robot::MarkDescription& target)
      : options_(options),
        demo_(demo),
        target_(target),
        rig_(options.lcm_url, "", demo.lockstep ? Rig::Pace::kLockstep : Rig::Pace::kRealTime),
        latency_(rig_.bus()),
        eyes_(rig_.bus(), latency_),
        stale_motion_(rig_.bus()) {}

  Course run() {
    rig_.wait_for_world();
    rig_.unlatch();
    for (int i = 0; i < 3; ++i) rig_.step([this] { return rig_.task_answered(); });
    TaskCommand start{};
    start.kind = TaskCommand::START;
    start.target = demo_.target;
    start.carry = demo_.carry;
    rig_.command(start);
    begin_ = rig_.truth().utime;
    Course course;
    int8_t shown = -1;
    int attempt = 0;
    while (true) {
      const TaskState& task = rig_.task();
      if (task.state != shown || task.attempt != attempt) {
        tell(task);
        picture(task.state);
        if (shown == TaskState::SERVO) course.servo.error = grip_error(rig_.truth(), target_);
        if (task.state == TaskState::APPROACH) course.servo.frames = 0;
        shown = task.state;
        attempt = task.attempt;
      }
      if (task.state == TaskState::SERVO) ++course.servo.frames;
      stale_motion_.observe(rig_.truth());
      if (task.state >= TaskState::LIFT_ON) course.lift.observe(rig_.truth(), demo_.target);
      const double elapsed = seconds(rig_.truth().utime - begin_);
      if (ended(task, demo_.carry) || elapsed > kPatience) {
        course.duration = elapsed;
        break;
      }
      rig_.step([this] { return rig_.task_answered(); });
    }
    course.last = rig_.task();
    watch_the_lift(course);
    return course;
  }

  const std::vector<double>& latency_ms() const { return latency_.milliseconds(); }
  double stale_motion() const { return stale_motion_.moved(); }

 private:
  // The book must still hang there a second later.
  void watch_the_lift(Course& course) {
    if (course.last.state != TaskState::HOLD_LIFTED) return;
    const int64_t until = rig_.truth().utime + static_cast<int64_t>(1e6 * (kLiftedTime + 0.1));
    course.lift.since.reset();
    course.lift.longest = 0.0;
    while (rig_.truth().utime < until) {
      rig_.step([this] { return rig_.task_answered(); });
      course.lift.observe(rig_.truth(), demo_.target);
    }
  }

  void tell(const TaskState& task) const {
    std::printf("%6.2f s  %-12s %s%s%s\n", seconds(rig_.truth().utime - begin_), task_state_name(task.state),
                task_state_words(task.state), task.reason.empty() ? "" : ": ", task.reason.c_str());
    std::fflush(stdout);
  }

  void picture(int8_t state) const {
    const auto write = [&](const char* name, const std::string& title) {
      eyes_.write((std::filesystem::path(options_.out) / name).string(), rig_.detection(), title);
    };
    if (state == TaskState::APPROACH || state == TaskState::REFUSED) write("look.png", "look");
    if (state == TaskState::GRIP) write("grip.png", "at the grip");
    if (state == TaskState::HOLD_LIFTED || state == TaskState::CARRY) write("lift.png", "after the lift");
  }

  ExperimentOptions options_;
  DemoOptions demo_;
  robot::MarkDescription target_;
  Rig rig_;
  CommandLatency latency_;
  Eyes eyes_;
  StaleMotionWatch stale_motion_;
  int64_t begin_ = 0;
};

nlohmann::json number_or_null(double value) {
  return std::isfinite(value) ? nlohmann::json(value) : nlohmann::json();
}

void write_report(const ExperimentOptions& options, const Course& course, bool truly_lifted,
                  const std::vector<double>& latency_ms, double stale_motion) {
  const auto& error = course.servo.error;
  const nlohmann::json report{
      {"seed", options.seed},
      {"task",
       {{"result", task_result_name(course.last.result)},
        {"reason", course.last.reason},
        {"attempts", course.last.attempt},
        {"seconds", course.duration}}},
      {"truth", {{"lifted", truly_lifted}, {"height_gain_m", course.lift.highest}, {"held_s", course.lift.longest}}},
      {"servo",
       {{"frames", course.servo.frames},
        {"final_error_m", {number_or_null(error.x()), number_or_null(error.y()), number_or_null(error.z())}}}},
      {"safety", {{"moved_on_stale_input_rad", stale_motion}}},
      {"latency_ms",
       {{"frame_to_command_p50", number_or_null(percentile(latency_ms, 0.50))},
        {"frame_to_command_p99", number_or_null(percentile(latency_ms, 0.99))}}}};
  std::ofstream(std::filesystem::path(options.out) / "report.json") << report.dump(2) << "\n";
}

void print_table(const Course& course, bool truly_lifted, const std::vector<double>& latency_ms) {
  std::printf("\n");
  std::printf("  task          %s%s%s, %.1f s, attempt %d\n", task_result_name(course.last.result),
              course.last.reason.empty() ? "" : ": ", course.last.reason.c_str(), course.duration, course.last.attempt);
  std::printf("  truth         %s: up by %.1f mm, held free by both fingers for %.2f s\n",
              truly_lifted ? "lifted" : "not lifted", 1e3 * course.lift.highest, course.lift.longest);
  std::printf("  servo         %d frames, grip point off by %.2f %.2f %.2f mm (x y z)\n", course.servo.frames,
              1e3 * course.servo.error.x(), 1e3 * course.servo.error.y(), 1e3 * course.servo.error.z());
  std::printf("  frame to command  p50 %.1f ms, p99 %.1f ms\n", percentile(latency_ms, 0.50),
              percentile(latency_ms, 0.99));
}

bool run_demo(const ExperimentOptions& options, const DemoOptions& demo) {
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  const robot::MarkDescription* target = robot.find_mark(demo.target);
  if (target == nullptr || !target->grip) {
    throw std::runtime_error("target '" + demo.target + "' is not a mark with a grip in " + options.robot_file);
  }
  Demo run(options, demo, *target);
  const Course course = run.run();
  const bool truly_lifted = course.lift.longest >= kLiftedTime;
  write_report(options, course, truly_lifted, run.latency_ms(), run.stale_motion());
  print_table(course, truly_lifted, run.latency_ms());
  return truly_lifted && course.last.result == TaskState::RESULT_LIFTED;
}

}  // namespace
}  // namespace markservo::experiments

int main(int argc, char** argv) {
  markservo::experiments::DemoOptions demo;
  return markservo::experiments::run_experiment(
      "Runs and judges one task on the simulated robot", 1, argc, argv,
      [&](const markservo::experiments::ExperimentOptions& options) {
        return markservo::experiments::run_demo(options, demo);
      },
      [&](void* app) {
        auto* cli = static_cast<CLI::App*>(app);
        cli->add_option("--target", demo.target, "The mark of the object to take")->capture_default_str();
        cli->add_flag("--carry", demo.carry, "Carry it to the side, release it, go home");
        cli->add_flag("--lockstep", demo.lockstep, "The simulator runs in lockstep and waits for SIM_CONTROL");
      });
}
