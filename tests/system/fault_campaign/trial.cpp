#include "tests/system/fault_campaign/trial.hpp"

#include <algorithm>
#include <csignal>
#include <filesystem>

#include "common/time/seconds_between.hpp"
#include "tests/experiments/task_words.hpp"
#include "tests/system/fault_campaign/bars.hpp"
#include "tests/system/fault_campaign/recording_scan.hpp"

namespace markservo::campaign {
namespace {

constexpr double kRecovery_s = 15.0;
constexpr double kShortestRecovery_s = 5.0;  // counters, rates and sizes need so much to be judged
constexpr double kReadyFor_s = 2.0;
// By the world's time, and a little above the checker's, so that a task that never ends is seen.
const double kTaskPatience_s = Bars().task_patience + 2.0;
const double kTaskStands_s = Bars().task_stands + 1.0;
constexpr double kLongestTask_s = 150.0;  // the simulator runs at a third of real time at least

}  // namespace

Trial::Trial(Plan plan, BenchFolders folders) : plan_(std::move(plan)), bench_(std::move(folders)), work_(bench_) {
  for (std::size_t i = 0; i < plan_.faults.size(); ++i) {
    Course course;
    course.fault = make_fault(plan_.faults[i]);
    bench_.fact({{"kind", "fault"},
                 {"what", "planned"},
                 {"index", i},
                 {"describe", course.fault->describe()},
                 {"words", course.fault->words()},
                 {"excuses", course.fault->excuses()}});
    courses_.push_back(std::move(course));
  }
}

bool Trial::start_stack() {
  StackSetup setup;
  for (Course& course : courses_) course.fault->prepare(bench_, setup);
  const std::string wrapped = wrap_services(bench_, setup.settable_clocks);
  std::vector<std::string> arguments{
      "--build-dir",
      wrapped,
      "--log-dir",
      bench_.folders().out + "/services",
      "--patience",
      "40",
      "--simulator-args",
      "--seed " + std::to_string(plan_.seed % 1000 + 1) + RobotWork::simulator_arguments(plan_.phase)};
  arguments.insert(arguments.end(), setup.arguments.begin(), setup.arguments.end());
  bench_.set_task([this] { attend(); });
  recorder_ = bench_.start("record", {bench_.folders().repository + "/scripts/record", "--without-frames", "--min-free",
                                      "0", "--out", bench_.folders().out + "/recording"});
  const int code = bench_.run("stack-start", bench_.stack_command("start", arguments), 90.0);
  if (code != 0)
    problem_ = "scripts/stack start exited with " + std::to_string(code) + ": " + bench_.printed("stack-start");
  return code == 0;
}

// Faults may run programs, which listens again: no fault is entered twice.
void Trial::attend() {
  if (attending_) return;
  attending_ = true;
  for (std::size_t i = 0; i < courses_.size(); ++i) {
    Course& course = courses_[i];
    course.fault->attend(bench_);
    if (course.strike_at == 0 || course.over) continue;
    const double since = seconds_between(course.strike_at, Bench::now());
    if (!course.striking && since >= 0.0) {
      course.striking = true;
      bench_.fact({{"kind", "fault"}, {"what", "strike"}, {"index", i}});
      course.fault->strike(bench_);
    } else if (course.striking && since < course.fault->plan().duration) {
      course.fault->tick(bench_);
    } else if (course.striking) {
      course.fault->end(bench_);
      course.over = true;
      bench_.fact({{"kind", "fault"}, {"what", "end"}, {"index", i}});
    }
  }
  attending_ = false;
}

void Trial::strike_all() {
  const std::int64_t moment = Bench::now() + static_cast<std::int64_t>(plan_.phase_delay * 1e6);
  double longest = 0.0;
  for (Course& course : courses_) {
    const FaultPlan& fault = course.fault->plan();
    course.strike_at = moment + static_cast<std::int64_t>(fault.offset * 1e6);
    longest = std::max(longest, fault.offset + fault.duration);
  }
  bench_.listen(longest + 60.0, [this] {
    return std::all_of(courses_.begin(), courses_.end(), [](const Course& course) { return course.over; });
  });
}

void Trial::recover() {
  const std::int64_t gone = Bench::now();
  std::int64_t well_since = 0;
  bench_.listen(kRecovery_s, [&] {
    const std::set<std::string> ready = bench_.ready();
    const bool well =
        std::includes(ready.begin(), ready.end(), ready_before_.begin(), ready_before_.end()) && work_.task_ended();
    if (!well) well_since = 0;
    if (well && well_since == 0) well_since = Bench::now();
    return well && seconds_between(well_since, Bench::now()) > kReadyFor_s &&
           seconds_between(gone, Bench::now()) > kShortestRecovery_s;
  });
  if (!work_.task_ended()) wait_for_the_task(gone);
}

// A task that is under way when the robot is well again is waited for: until it ends, or nothing of it goes on.
void Trial::wait_for_the_task(std::int64_t gone) {
  work_.watch_for_standstill();
  const double began = work_.world_seconds() - seconds_between(gone, Bench::now());
  bench_.listen(kLongestTask_s, [this, began] {
    return work_.task_ended() || work_.stands_for() > kTaskStands_s || work_.world_seconds() - began > kTaskPatience_s;
  });
}

void Trial::end_all() {
  bench_.fact({{"kind", "end"}});
  bench_.run("stack-status", bench_.stack_command("status"), 15.0);
  const std::int64_t end = Bench::now();
  if (recorder_) {
    recorder_->signal(SIGINT);
    bench_.listen(15.0, [this] { return recorder_->ended(); });
    recorder_.reset();
  }
  bench_.run("stack-stop", bench_.stack_command("stop"), 30.0);
  // Reading takes long, and nothing is heard meanwhile: when there is no more to hear.
  nlohmann::json recording = scan_recording(bench_.folders().out + "/recording");
  recording["kind"] = "recording";
  recording["ended"] = end;
  for (const Course& course : courses_) {
    if (!course.fault->ends_recording() || !course.striking) continue;
    recording["ended"] = std::min(end, course.strike_at);
    recording.erase("manifest");  // it is on the same disk
  }
  bench_.fact(recording);
  print_recording();
  std::error_code error;
  const std::filesystem::path out(bench_.folders().out);
  for (const auto& entry : std::filesystem::directory_iterator(out / "services", error)) {
    if (entry.is_regular_file())
      std::filesystem::copy_file(entry.path(), out / "printed" / entry.path().filename(), error);
  }
}

// What the tools say of the recording, for what messages held goes through them to a terminal.
void Trial::print_recording() {
  const std::filesystem::path out(bench_.folders().out);
  const std::string recording = out / "recording";
  const std::string tool = bench_.folders().build + "/bin/log-tool";
  std::error_code error;
  std::filesystem::copy_file(out / "recording" / "manifest.json", out / "printed" / "manifest.json", error);
  if (!std::filesystem::exists(tool)) return;
  bench_.run("log-info", {tool, "info", recording}, 15.0);
  bench_.run("log-info-json", {tool, "info", "--json", recording}, 15.0);
  const std::string tables = out / "tables";
  bench_.run("log-export",
             {tool, "export", recording, tables, "--channel", "STOP|STOP_STATE|TASK_COMMAND|TASK_STATE|SERVICE_STATUS"},
             15.0);
  for (const auto& entry : std::filesystem::directory_iterator(tables, error)) {
    if (entry.path().extension() == ".csv") {
      std::filesystem::copy_file(entry.path(), out / "printed" / entry.path().filename(), error);
    }
  }
  std::filesystem::remove_all(tables, error);
}

nlohmann::json Trial::report(bool phase_reached) const {
  nlohmann::json faults = nlohmann::json::array();
  bool struck = phase_reached;
  for (const Course& course : courses_) {
    nlohmann::json fault = json_of(course.fault->plan());
    const std::string evidence = course.over ? course.fault->evidence() : "";
    fault["what"] = course.fault->describe();
    fault["evidence"] = evidence;
    struck = struck && !evidence.empty();
    faults.push_back(fault);
  }
  const TaskState& task = bench_.task();
  return {{"seed", plan_.seed},
          {"draw", plan_.draw},
          {"phase", plan_.phase},
          {"phase_reached", phase_reached},
          {"struck", struck},
          {"problem", problem_},
          {"faults", faults},
          {"task",
           {{"result", experiments::task_result_name(task.result)},
            {"state", experiments::task_state_name(task.state)},
            {"reason", task.reason.substr(0, 500)}}}};
}

nlohmann::json Trial::run() {
  bool phase_reached = false;
  if (start_stack()) {
    phase_reached = work_.bring_to(plan_.phase);
    if (!phase_reached) problem_ = work_.problem();
    ready_before_ = bench_.ready(5.0);
    if (phase_reached) {
      strike_all();
      recover();
    }
  }
  end_all();
  return report(phase_reached);
}

}  // namespace markservo::campaign
