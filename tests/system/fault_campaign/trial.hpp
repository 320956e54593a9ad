#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/system/fault_campaign/bench.hpp"
#include "tests/system/fault_campaign/fault.hpp"
#include "tests/system/fault_campaign/plan.hpp"
#include "tests/system/fault_campaign/robot_work.hpp"

namespace markservo::campaign {

// One plan carried out on a stack of its own. Leaves the history in the bench's folder.
class Trial {
 public:
  Trial(Plan plan, BenchFolders folders);

  // What happened: {"seed", "draw", "phase", "phase_reached", "struck", "problem", "faults": [...], "task": {...}}.
  nlohmann::json run();

 private:
  struct Course {
    std::unique_ptr<Fault> fault;
    std::int64_t strike_at = 0;  // us
    bool striking = false;
    bool over = false;
  };

  bool start_stack();
  void attend();
  void strike_all();
  void recover();
  void wait_for_the_task(std::int64_t gone);
  void end_all();
  void print_recording();
  nlohmann::json report(bool phase_reached) const;

  Plan plan_;
  Bench bench_;
  RobotWork work_;
  std::vector<Course> courses_;
  std::set<std::string> ready_before_;
  std::unique_ptr<Child> recorder_;
  std::string problem_;
  bool attending_ = false;
};

}  // namespace markservo::campaign
