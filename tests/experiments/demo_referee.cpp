// Runs one task on a simulated robot whose services are up, tells what happens line by line, and judges it by the
// simulator's truth. Used by scripts/demo. Exit code 0 only if the task says lifted and the truth agrees.
//   in:  TASK_STATE, SERVO_STATUS, SIM_TRUTH, STEREO_FRAME, MARK_DETECTION, STEREO_MATCHES, TARGET_POSE, JOINT_STATE,
//        JOINT_COMMAND, SIM_BASE_TRUTH, ROBOT_POSE, BASE_COMMAND, BASE_GOAL
//   out: SIM_CONTROL, STOP, TASK_COMMAND; DIR/report.json, DIR/{look,grip,lift}.png, with --drive DIR/drive.png

#include <cstdint>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "common/bus/options.hpp"
#include "common/robot/configuration_error.hpp"
#include "tests/experiments/aim_watch.hpp"
#include "tests/experiments/bus_counts.hpp"
#include "tests/experiments/demo_pictures.hpp"
#include "tests/experiments/demo_watches.hpp"
#include "tests/experiments/drive_picture.hpp"
#include "tests/experiments/drive_truth.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/experiments/lift_truth.hpp"
#include "tests/experiments/rig.hpp"
#include "tests/experiments/stale_drive.hpp"
#include "tests/experiments/statistics.hpp"
#include "tests/experiments/task_words.hpp"
#include "tests/experiments/touch_watch.hpp"

namespace markservo::experiments {
namespace {

constexpr double kLiftedTime = 1.0;  // s, held free
constexpr double kPatience = 120.0;  // s of the world's time, for the whole task without its drive
constexpr double kDrivePatience = 180.0;
constexpr double kAftermath = 1.5;  // s, watched after the task's end
constexpr double kRestTime = 0.5;   // s, the last of them: all must be at rest

struct DemoOptions {
  std::string target = "red_book";
  std::vector<double> drive;  // x and y (m), heading (degrees) on the tag field; empty: stand
  bool carry = false;
  bool lockstep = false;
};

// Seconds of the world's time that went by, whatever it begins with anew: a simulator that restarts sets it back.
class CourseClock {
 public:
  void see(std::int64_t utime) {
    if (last_ && utime > *last_) passed_us_ += utime - *last_;
    last_ = utime;
  }
  double seconds() const { return 1e-6 * static_cast<double>(passed_us_); }

 private:
  std::optional<std::int64_t> last_;
  std::int64_t passed_us_ = 0;
};

std::optional<Pose2> drive_pose(const DemoOptions& demo) {
  if (demo.drive.empty()) return std::nullopt;
  Pose2 pose{};
  pose.x = demo.drive[0];
  pose.y = demo.drive[1];
  pose.heading = geometry::radians(demo.drive[2]);
  return pose;
}

struct Course {
  TaskState last;
  double duration = 0.0;  // s of the world's time, START to the task's end
  Aim aim;
  LiftWatch lift;
  std::optional<CarriedBook> carried;  // with --carry
  double moved_at_end = 0.0;           // rad, when all should be at rest
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
        aim_(demo.target, target.grip->p_TG),
        rig_(options.lcm_url, "", demo.lockstep ? Rig::Pace::kLockstep : Rig::Pace::kRealTime),
        latency_(rig_.bus()),
        eyes_(rig_.bus(), [this](std::int64_t seq) { latency_.frame(seq); }),
        stale_motion_(rig_.bus()),
        drive_(rig_.bus()),
        stale_drive_(rig_.bus()),
        counts_(rig_.bus()) {}

  Course run() {
    rig_.wait_for_world();
    rig_.unlatch([this] { return rig_.task_answered(); });
    for (int i = 0; i < 3; ++i) rig_.step([this] { return rig_.task_answered(); });
    TaskCommand start{};
    start.kind = TaskCommand::START;
    start.target = demo_.target;
    start.carry = demo_.carry;
    const auto goal = drive_pose(demo_);
    if (goal) {
      start.drive = 1;
      start.drive_pose = *goal;
    }
    rig_.command(start);
    const double patience = kPatience + (goal ? kDrivePatience : 0.0);
    clock_.see(rig_.truth().utime);
    SimTruth before = rig_.truth();
    Course course;
    std::int8_t shown = -1;
    int attempt = 0;
    while (true) {
      const TaskState& task = rig_.task();
      if (task.state != shown || task.attempt != attempt) {
        tell(task);
        picture(task.state);
        shown = task.state;
        attempt = task.attempt;
      }
      aim_.observe(rig_.truth(), task.state);
      stale_motion_.observe(rig_.truth(), task.state);
      touch_.observe(rig_.truth(), task.state);
      drive_.observe(task.state);
      if (task.state == TaskState::DRIVE)
        before = rig_.truth();  // C drives along: places are told from the drive's end
      course.lift.observe(rig_.truth(), demo_.target, task.state);
      const double elapsed = clock_.seconds();
      if (ended(task, demo_.carry) || elapsed > patience) {
        course.duration = elapsed;
        break;
      }
      step();
    }
    course.last = rig_.task();
    course.aim = aim_.aim();
    watch_the_aftermath(course, before);
    return course;
  }

  const std::vector<double>& latency_ms() const { return latency_.milliseconds(); }
  const StaleMotionWatch& stale_motion() const { return stale_motion_; }
  const DriveWatch& drive() const { return drive_; }
  const StaleDriveWatch& stale_drive() const { return stale_drive_; }
  const TouchWatch& touch() const { return touch_; }
  const BusCounts& counts() const { return counts_; }
  const SimTruth& truth() const { return rig_.truth(); }

 private:
  void step() {
    rig_.step([this] { return rig_.task_answered(); });
    clock_.see(rig_.truth().utime);
  }

  // A lifted book must still hang there a second later, a carried one stand, and the arm must come to rest.
  void watch_the_aftermath(Course& course, const SimTruth& before) {
    const double end = clock_.seconds();
    std::optional<SimTruth> earlier;
    const auto elapsed = [&] { return clock_.seconds() - end; };
    while (elapsed() < kAftermath) {
      step();
      course.lift.observe(rig_.truth(), demo_.target, course.last.state);
      touch_.observe(rig_.truth(), course.last.state);
      if (earlier || elapsed() < kAftermath - kRestTime) continue;
      earlier = rig_.truth();
      drive_.expect_rest();
    }
    course.moved_at_end = farthest_joint(rig_.truth().shaft, earlier->shaft);
    if (!demo_.carry) return;
    const SimBody* first = find_body(before, demo_.target);
    const SimBody* then = find_body(*earlier, demo_.target);
    const SimBody* last = find_body(rig_.truth(), demo_.target);
    course.carried = CarriedBook{};
    if (first != nullptr && then != nullptr && last != nullptr) {
      course.carried = judge_carried(*first, *then, *last, target_.grip->spacing);
    }
  }

  void tell(const TaskState& task) const {
    std::printf("%6.2f s  %-12s %s%s%s\n", clock_.seconds(), task_state_name(task.state), task_state_words(task.state),
                task.reason.empty() ? "" : ": ", task.reason.c_str());
    std::fflush(stdout);
  }

  void picture(std::int8_t state) const {
    const auto write = [&](const char* name, const std::string& title) {
      eyes_.write((std::filesystem::path(options_.out) / name).string(), title);
    };
    if (state == TaskState::APPROACH || state == TaskState::REFUSED) write("look.png", "look");
    if (state == TaskState::GRIP) write("grip.png", "at the grip");
    if (state == TaskState::HOLD_LIFTED || state == TaskState::CARRY) write("lift.png", "after the lift");
  }

  ExperimentOptions options_;
  DemoOptions demo_;
  robot::MarkDescription target_;
  AimWatch aim_;
  Rig rig_;
  CommandLatency latency_;
  Eyes eyes_;
  StaleMotionWatch stale_motion_;
  DriveWatch drive_;
  StaleDriveWatch stale_drive_;
  TouchWatch touch_;
  BusCounts counts_;
  CourseClock clock_;
};

using Json = nlohmann::ordered_json;  // the report begins with what a reader looks for first

Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json();
}

Json truth_report(const Course& course, bool truly_lifted) {
  Json json{{"lifted", truly_lifted}, {"height_gain_m", course.lift.highest()}, {"held_s", course.lift.held()}};
  if (course.carried) {
    json["carried"] = {{"stands_elsewhere", course.carried->stands_elsewhere},
                       {"released", course.carried->released},
                       {"still", course.carried->still},
                       {"tilt_deg", course.carried->tilt_deg},
                       {"displacement_m", course.carried->displacement}};
  }
  return json;
}

Json report_of(const ExperimentOptions& options, const Course& course, bool truly_lifted,
               const std::vector<double>& latency_ms, const StaleMotionWatch& stale_motion, const TouchWatch& touch) {
  // When the fingers begin to close, by truth: grip point minus its goal, x y z in C; null if nothing was gripped.
  const auto& error = course.aim.error;
  const Json error_m = error ? Json{error->x(), error->y(), error->z()} : Json();
  const auto stale_phase = stale_motion.phase();
  return {{"seed", options.seed},
          {"task",
           {{"result", task_result_name(course.last.result)},
            {"state", task_state_name(course.last.state)},
            {"reason", course.last.reason},
            {"attempts", course.last.attempt},
            {"seconds", course.duration}}},
          {"truth", truth_report(course, truly_lifted)},
          {"servo", {{"frames", course.aim.frames}, {"final_error_m", error_m}}},
          {"safety",
           {{"moved_on_stale_input_rad", stale_motion.moved()},
            {"stale_s", stale_motion.longest()},  // longest without a fresh command
            {"stale_phase", stale_phase ? Json(task_state_name(*stale_phase)) : Json()},
            {"touched", touch.touched()},  // the first pair; empty: the arm touched nothing
            {"touched_phase", touch.phase() ? Json(task_state_name(*touch.phase())) : Json()},
            {"moved_at_end_rad", number_or_null(course.moved_at_end)}}},
          {"latency_ms",
           {{"frame_to_command_p50", number_or_null(percentile(latency_ms, 0.50))},
            {"frame_to_command_p99", number_or_null(percentile(latency_ms, 0.99))}}}};
}

void print_table(const Course& course, bool truly_lifted, const std::vector<double>& latency_ms) {
  std::printf("\n");
  std::printf("  task          %s%s%s, %.1f s, attempt %d\n", task_result_name(course.last.result),
              course.last.reason.empty() ? "" : ": ", course.last.reason.c_str(), course.duration, course.last.attempt);
  std::printf("  truth         %s: up by %.1f mm, held free by both fingers for %.2f s from the lift's end\n",
              truly_lifted ? "lifted" : "not lifted", 1e3 * course.lift.highest(), course.lift.held());
  if (course.carried) {
    std::printf("                %s: %.1f cm from its old place, %.1f degrees from upright%s%s\n",
                course.carried->stands_elsewhere ? "carried" : "not carried", 1e2 * course.carried->displacement,
                course.carried->tilt_deg, course.carried->released ? "" : ", still touched by the fingers",
                course.carried->still ? "" : ", still moving");
  }
  const Eigen::Vector3d error_mm = 1e3 * course.aim.error.value_or(Eigen::Vector3d::Constant(NAN));
  std::printf("  servo         %d frames, grip point off by %.2f mm: %.2f %.2f %.2f (x y z)\n", course.aim.frames,
              error_mm.norm(), error_mm.x(), error_mm.y(), error_mm.z());
  std::printf("  frame to command  p50 %.1f ms, p99 %.1f ms\n", percentile(latency_ms, 0.50),
              percentile(latency_ms, 0.99));
}

bool run_demo(const ExperimentOptions& options, const DemoOptions& demo) {
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  const robot::MarkDescription* target = robot.find_mark(demo.target);
  if (target == nullptr || !target->grip) {
    throw ConfigurationError("--target is '" + demo.target + "'; allowed: a mark with a grip in " + options.robot_file);
  }
  Demo run(options, demo, *target);
  const Course course = run.run();
  const bool truly_lifted = course.lift.held() >= kLiftedTime;
  Json report = report_of(options, course, truly_lifted, run.latency_ms(), run.stale_motion(), run.touch());
  print_table(course, truly_lifted, run.latency_ms());
  bool truly_done = truly_lifted && (!course.carried || course.carried->stands_elsewhere);
  const std::filesystem::path out = options.out;
  if (const auto goal = drive_pose(demo)) {
    const DriveResult drive = run.drive().result(*goal);
    report["drive"] = experiments::report_of(drive, *goal);
    report["drive"]["silences"] = experiments::report_of(run.stale_drive());
    std::printf("%s", words_of(drive).c_str());
    write_drive_picture((out / "drive.png").string(), robot, run.drive(), *goal, run.truth());
    truly_done = truly_done && truly_driven(drive);
  }
  report["bus"] = run.counts().report();  // some hundred lines
  std::ofstream(out / "report.json") << report.dump(2) << "\n";
  return truly_done && course.last.result == TaskState::RESULT_LIFTED;
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
      [&](CLI::App& app) {
        const markservo::bus::Options add(app);
        add.option("--target", demo.target, "The mark of the object to take").show_default();
        add.option("--drive", demo.drive, "X,Y,HEADING_DEG: drive there first (m and degrees on the tag field)")
            .delimiter(',')
            .expected(3);
        add.flag("--carry", demo.carry, "Carry it to the side, release it, go home");
        add.flag("--lockstep", demo.lockstep, "The simulator runs in lockstep and waits for SIM_CONTROL");
      });
}
