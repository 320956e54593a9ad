// I4 and I12: what the hand does.

#include <algorithm>
#include <cmath>
#include <markservo/SimBody.hpp>

#include "tests/experiments/lift_truth.hpp"
#include "tests/system/fault_campaign/invariants.hpp"
#include "tests/system/fault_campaign/motion.hpp"
#include "tests/system/fault_campaign/words.hpp"

namespace markservo::campaign {
namespace {

// Whether the task lets go at `t`, by the stack's word: it releases or goes home, or is done with that. A task may also
// be done with nothing let go.
bool releases(const Timeline& timeline, std::int64_t t) {
  int state = -1;
  int before = -1;  // the state that it was in before
  for (const auto& heard : timeline.task_states) {
    if (heard.t > t) break;
    if (heard.foreign || !timeline.is("task-manager", heard.message.session) || heard.message.state == state) continue;
    before = state;
    state = heard.message.state;
  }
  const auto lets_go = [](int one) { return one == TaskState::RELEASE || one == TaskState::GO_HOME; };
  return lets_go(state) || (state == TaskState::DONE && lets_go(before));
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
  return releases(timeline, t) || releases(timeline, t + moment);
}

double apart(const SimBody& a, const SimBody& b) {
  return std::hypot(a.p_CB.x - b.p_CB.x, a.p_CB.y - b.p_CB.y, a.p_CB.z - b.p_CB.z);
}

// What is not the target stays where it is. Places are told as the camera sees them, which rides on the base: it is how
// far two bodies are from each other, and each one's height, that tell.
void judge_moved_bodies(const Timeline& timeline, const SimTruth& first, const Heard<SimTruth>& truth, const Bars& bars,
                        Verdict& verdict) {
  const std::vector<SimBody>& then = first.bodies;
  const std::vector<SimBody>& now = truth.message.bodies;
  if (then.size() != now.size()) return;
  for (std::size_t i = 0; i < now.size(); ++i) {
    if (now[i].name == timeline.target) continue;
    double moved = std::abs(now[i].height_gain - then[i].height_gain);
    for (std::size_t j = 0; j < i; ++j) {
      if (now[j].name != timeline.target)
        moved = std::max(moved, std::abs(apart(now[i], now[j]) - apart(then[i], then[j])));
    }
    if (moved <= bars.body_still_m) continue;
    note(verdict, truth.t,
         text("%s was moved by %.1f mm by %.2f s (world), task state %d", now[i].name.c_str(), 1e3 * moved, truth.world,
              timeline.task_state_at(truth.t)));
    return;
  }
}

// The hand may be at the target: it closes, holds or opens, or did a moment ago.
bool may_touch(const Timeline& timeline, std::int64_t t, const Bars& bars) {
  const auto moment = static_cast<std::int64_t>(bars.release_seen * 1e6);
  return !hand_is_free(timeline.task_state_at(t)) || !hand_is_free(timeline.task_state_at(t + moment)) ||
         !hand_is_free(timeline.task_state_at(t - moment));
}

// Each pair that is told: the first since the reset (SimTruth.touched), and of every body whether a finger touches it
// now, and whether something else does: what stood on its own before is struck by the arm or by what the hand carries.
void judge_touches(const Timeline& timeline, const SimTruth* last, const Heard<SimTruth>& truth, const Bars& bars,
                   Verdict& verdict) {
  const SimTruth& now = truth.message;
  const auto wrong = [&](const std::string& what) {
    note(verdict, truth.t,
         text("touched %s at %.2f s (world), task state %d", what.c_str(), truth.world,
              timeline.task_state_at(truth.t)));
  };
  const std::string end = " - " + (timeline.target.empty() ? std::string("?") : timeline.target);
  const bool first = now.arm_touched && last != nullptr && !last->arm_touched;
  const bool finger_on_target = now.touched == "finger_left" + end || now.touched == "finger_right" + end;
  if (first && !(finger_on_target && may_touch(timeline, truth.t, bars))) wrong(now.touched);
  for (const SimBody& body : now.bodies) {
    if (!body.touches_left_finger && !body.touches_right_finger) continue;
    const bool before = last != nullptr && std::any_of(last->bodies.begin(), last->bodies.end(), [&](const auto& one) {
                          return one.name == body.name && (one.touches_left_finger || one.touches_right_finger);
                        });
    const bool target = body.name == timeline.target;
    if (before || (target && may_touch(timeline, truth.t, bars))) continue;
    wrong(std::string(body.touches_left_finger ? "finger_left" : "finger_right") + " - " + body.name);
  }
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
  const Heard<SimTruth>* last = nullptr;
  const Heard<SimTruth>* settled = nullptr;  // the first of its world once the bodies stand
  double began = 0.0;                        // s, world
  for (const auto& truth : timeline.truth) {
    ++verdict.judged;
    const bool same = last != nullptr && same_world(last->message, truth.message);
    judge_touches(timeline, same ? &last->message : nullptr, truth, bars, verdict);
    if (!same) settled = nullptr;
    if (!same) began = truth.world;
    if (settled == nullptr && truth.world - began >= bars.bodies_settle) settled = &truth;
    if (settled != nullptr) judge_moved_bodies(timeline, settled->message, truth, bars, verdict);
    last = &truth;
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
