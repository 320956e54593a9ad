#include "services/mmi/troubles/watches/base_troubles.hpp"

namespace markservo::mmi {

void BaseTroubles::observe(const PoseWord& word, double now) {
  pose_.observe(word, now);
}

void BaseTroubles::observe(const BaseWord& word, double now) {
  base_.observe(word, now);
}

void BaseTroubles::find(const Remedies& remedies, double now, Findings& found) const {
  const auto counts = [&](const auto& heard) { return heard.word && now - heard.heard <= parameters_.word; };
  const auto tell = [&](TroubleCode code, const Since& since, const std::string& text, const std::string& remedy) {
    found.push_back({{code, "base", since.utime, text, remedy}, since.now});
  };
  const bool base_counts = counts(base_);
  if (counts(pose_) && pose_.word->state == LocalisationState::kLost) {
    tell(TroubleCode::kPoseLost, pose_.since, "where the robot stands is lost: " + pose_.word->reason,
         remedies.pose_lost());
  } else if (base_counts && base_.word->state == BaseState::kLost) {
    tell(TroubleCode::kPoseLost, base_.since, "the drive waits to know where the robot stands: " + base_.word->reason,
         remedies.pose_lost());
  }
  if (base_counts && base_.word->state == BaseState::kBlocked) {
    tell(TroubleCode::kBaseBlocked, base_.since, "something stands in the way: " + base_.word->reason,
         remedies.base_blocked());
  }
}

}  // namespace markservo::mmi
