// What the table of a task's transitions must hold, whoever runs it.

#include "common/task/transitions.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace markservo {
namespace {

std::vector<TaskPhase> all_phases() {
  std::vector<TaskPhase> phases;
  for (int code = 0; code <= static_cast<int>(TaskPhase::kDrive); ++code)
    phases.push_back(static_cast<TaskPhase>(code));
  return phases;
}

// All that can be reached from `begin`, itself included.
std::set<TaskPhase> reached_from(TaskPhase begin) {
  std::set<TaskPhase> reached{begin};
  for (std::size_t before = 0; before != reached.size();) {
    before = reached.size();
    for (const TaskTransition& transition : kTaskTransitions) {
      if (reached.count(transition.from) > 0) reached.insert(transition.to);
    }
  }
  return reached;
}

TEST(TaskTransitions, AreEachInTheTableOnceWithAWord) {
  std::set<std::pair<TaskPhase, TaskPhase>> seen;
  for (const TaskTransition& transition : kTaskTransitions) {
    EXPECT_NE(transition.from, transition.to) << name_of(transition.from);
    EXPECT_TRUE(seen.emplace(transition.from, transition.to).second)
        << name_of(transition.from) << " to " << name_of(transition.to);
    EXPECT_STRNE(transition.when, "");
  }
}

TEST(TaskTransitions, LeadFromIdleToEveryPhaseAndNeverBackToIt) {
  EXPECT_EQ(reached_from(TaskPhase::kIdle).size(), all_phases().size());
  for (const TaskPhase phase : all_phases()) EXPECT_FALSE(may_follow(phase, TaskPhase::kIdle)) << name_of(phase);
}

TEST(TaskTransitions, EndWhatIsUnderWayByFailureAndByStop) {
  for (const TaskPhase phase : all_phases()) {
    if (!under_way(phase)) continue;
    EXPECT_TRUE(may_follow(phase, TaskPhase::kFailed)) << name_of(phase);
    EXPECT_TRUE(may_follow(phase, TaskPhase::kStopped)) << name_of(phase);
  }
}

TEST(TaskTransitions, LetEveryPhaseComeHome) {
  for (const TaskPhase phase : all_phases())
    EXPECT_EQ(reached_from(phase).count(TaskPhase::kDone), 1U) << name_of(phase);
}

TEST(TaskTransitions, CloseTheHandOnlyAfterALookAndServoing) {
  for (const TaskPhase phase : all_phases()) {
    EXPECT_EQ(may_follow(phase, TaskPhase::kApproach), phase == TaskPhase::kLook) << name_of(phase);
    EXPECT_EQ(may_follow(phase, TaskPhase::kServo), phase == TaskPhase::kApproach) << name_of(phase);
    EXPECT_EQ(may_follow(phase, TaskPhase::kGrip), phase == TaskPhase::kServo) << name_of(phase);
  }
}

}  // namespace
}  // namespace markservo
