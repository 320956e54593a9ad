#include "services/mmi/troubles/watches/mark_troubles.hpp"

#include <algorithm>

namespace markservo::mmi {
namespace {

Since later(const Since& a, const Since& b) {
  return a.now >= b.now ? a : b;
}

}  // namespace

void MarkTroubles::observe(const TaskWord& word, double now) {
  if (!task_ || task_->phase != word.phase || task_->target != word.target) phase_ = {now, word.at};
  task_ = word;
  task_heard_ = now;
}

void MarkTroubles::observe(const ServoWord& word, double now) {
  const bool was_lost = servo_ && servo_->state == ServoState::kLost;
  if (word.state == ServoState::kLost && !was_lost) servo_lost_ = {now, word.at};
  if (word.settled && !(servo_ && servo_->settled)) settled_ = {now, word.at};
  servo_ = word;
}

void MarkTroubles::observe(const MarksWord& word, double now) {
  marks_heard_ = Since{now, word.at};
  for (const MarkWord& seen : word.marks) {
    Mark* mark = known_or_new(marks_, seen.name, now);
    if (mark == nullptr) continue;
    if (seen.status != MarkStatus::kLocated && mark->status == MarkStatus::kLocated) mark->since = {now, word.at};
    mark->is_hand = seen.is_hand;
    mark->status = seen.status;
    mark->heard = now;
  }
}

bool MarkTroubles::needs_target() const {
  switch (task_->phase) {
    case TaskPhase::kLook:
    case TaskPhase::kServo:
    case TaskPhase::kGrip:
    case TaskPhase::kVerify:
      return true;
    default:
      return false;
  }
}

bool MarkTroubles::needs_hand() const {
  switch (task_->phase) {
    case TaskPhase::kApproach:
      return servo_ && servo_->settled;  // before the target
    case TaskPhase::kServo:
    case TaskPhase::kGrip:
    case TaskPhase::kVerify:
      return true;
    default:
      return false;
  }
}

std::optional<Finding> MarkTroubles::target_unseen(double now) const {
  const std::string& name = task_->target;
  const auto known = marks_.find(name);
  const bool listed = known != marks_.end() && now - known->second.heard <= parameters_.marks;
  if (listed && known->second.status == MarkStatus::kLocated) return std::nullopt;
  const Since since = listed ? later(known->second.since, phase_) : phase_;
  const std::string why = listed ? name_of(known->second.status) : "it is not looked for";
  return Finding{{TroubleCode::kMarkUnseen, name, since.utime, "the target's mark " + name + ": " + why, {}},
                 since.now};
}

std::optional<Finding> MarkTroubles::hand_unseen(double now) const {
  for (const auto& [name, mark] : marks_) {
    if (!mark.is_hand || mark.status == MarkStatus::kLocated || now - mark.heard > parameters_.marks) continue;
    Since since = later(mark.since, phase_);
    if (task_->phase == TaskPhase::kApproach) since = later(since, settled_);
    return Finding{
        {TroubleCode::kHandUnseen, name, since.utime, "the hand's mark " + name + ": " + name_of(mark.status), {}},
        since.now};
  }
  return std::nullopt;
}

// Both are located, but what is taken for the hand's mark is elsewhere than the hand.
std::optional<Finding> MarkTroubles::servo_lost() const {
  if (task_->phase != TaskPhase::kServo || !servo_ || servo_->state != ServoState::kLost) return std::nullopt;
  const auto hand = std::find_if(marks_.begin(), marks_.end(), [](const auto& mark) { return mark.second.is_hand; });
  const Since since = later(servo_lost_, phase_);
  return Finding{{TroubleCode::kHandUnseen,
                  hand == marks_.end() ? "hand" : hand->first,
                  since.utime,
                  "the hand is not seen where the joints say it is: " + servo_->reason,
                  {}},
                 since.now};
}

void MarkTroubles::find(const Remedies& remedies, double now, Findings& found) const {
  const bool task_known = task_ && now - task_heard_ <= parameters_.task;
  const bool marks_known = marks_heard_ && now - marks_heard_->now <= parameters_.marks;
  if (!task_known || !marks_known) return;
  auto target = needs_target() ? target_unseen(now) : std::nullopt;
  auto hand = needs_hand() ? hand_unseen(now) : std::nullopt;
  if (!target && !hand) hand = servo_lost();
  if (target) {
    target->trouble.remedy = remedies.mark_unseen();
    found.push_back(std::move(*target));
  }
  if (hand) {
    hand->trouble.remedy = remedies.hand_unseen();
    found.push_back(std::move(*hand));
  }
}

}  // namespace markservo::mmi
