// I4 and I12: what the hand does.

#include <algorithm>
#include <markservo/SimBody.hpp>

#include "tests/experiments/lift_truth.hpp"
#include "tests/system/fault_campaign/invariants.hpp"
#include "tests/system/fault_campaign/motion.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

bool releases(int task_state) {
  return task_state == TaskState::RELEASE || task_state == TaskState::GO_HOME || task_state == TaskState::DONE;
}

// Before the hand closes it touches nothing at all.
bool hand_is_free(int task_state) {
  return task_state < 0 || task_state == TaskState::IDLE || task_state == TaskState::DRIVE ||
         task_state == TaskState::LOOK || task_state == TaskState::APPROACH || task_state == TaskState::SERVO;
}

bool between_fingers(const SimBody& body, const Bars& bars) {
  return body.height_gain >= bars.held_height_m && body.touches_left_finger && body.touches_right_finger;
}

const SimBody* held_body(const SimTruth& truth, const Bars& bars) {
  for (const SimBody& body : truth.bodies) {
    if (between_fingers(body, bars)) return &body;
  }
  return nullptr;
}

// The task's state then or a moment later: it is told after the frame that it answers.
bool releases_around(const Timeline& timeline, std::int64_t t, const Bars& bars) {
  const auto moment = static_cast<std::int64_t>(bars.release_seen * 1e6);
  return releases(timeline.task_state_at(t)) || releases(timeline.task_state_at(t + moment));
}

}  // namespace

Verdict hand_keeps_what_it_lifted(const Timeline& timeline, const Bars& bars) {
  Verdict verdict;
  bool held = false;
  double narrowest = 0.0;  // m, opening while the present body hangs in the hand
  const Heard<SimTruth>* last = nullptr;
  for (const auto& truth : timeline.truth) {
    const bool same = last != nullptr && same_world(last->message, truth.message);
    const bool held_before = same && held;
    last = &truth;
    if (held_before) {
      ++verdict.judged;
      const double opened = truth.message.gripper_opening - narrowest;
      if (opened > bars.opens_m && !releases_around(timeline, truth.t, bars)) {
        note(verdict, truth.t,
             text("the hand opened by %.1f mm on a lifted object at %.2f s (world), task state %d", 1e3 * opened,
                  truth.world, timeline.task_state_at(truth.t)));
      }
    }
    held = held_body(truth.message, bars) != nullptr;
    const double opening = truth.message.gripper_opening;
    narrowest = held_before ? std::min(narrowest, opening) : opening;
  }
  return verdict;
}

Verdict touches_only_the_target(const Timeline& timeline, const Bars& bars) {
  Verdict verdict;
  const std::string end = " - " + (timeline.target.empty() ? std::string("?") : timeline.target);
  const Heard<SimTruth>* last = nullptr;
  for (const auto& truth : timeline.truth) {
    ++verdict.judged;
    const bool new_touch = truth.message.arm_touched &&
                           (last == nullptr || !last->message.arm_touched || !same_world(last->message, truth.message));
    const bool seen_before = last != nullptr && same_world(last->message, truth.message);
    last = &truth;
    if (!new_touch || !seen_before) continue;
    const std::string& pair = truth.message.touched;
    const bool finger_on_target = pair == "finger_left" + end || pair == "finger_right" + end;
    const auto moment = static_cast<std::int64_t>(bars.release_seen * 1e6);
    const bool may =
        !hand_is_free(timeline.task_state_at(truth.t)) || !hand_is_free(timeline.task_state_at(truth.t + moment));
    if (finger_on_target && may) continue;
    note(verdict, truth.t,
         text("touched %s at %.2f s (world), task state %d", pair.c_str(), truth.world,
              timeline.task_state_at(truth.t)));
  }
  bool base_touched = false;
  for (const auto& truth : timeline.base_truth) {
    ++verdict.judged;
    if (truth.message.touched && !base_touched)
      note(verdict, truth.t, text("the base ran into something at %.2f s (world)", truth.world));
    base_touched = truth.message.touched;
  }
  return verdict;
}

}  // namespace markservo::campaign
