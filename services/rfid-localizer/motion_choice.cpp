#include "services/rfid-localizer/motion_choice.hpp"

namespace markservo::rfid_localizer {

MotionChoice::MotionChoice(const WheelHistory& history, const Eigen::Vector2d& p_RF,
                           const WheelMotionParameters& wheels, const FreeMotionParameters& free,
                           const std::optional<WheelJudgeParameters>& judge)
    : history_(history), wheels_(history, p_RF, wheels), free_(p_RF, free) {
  if (judge) judge_.emplace(wheels.noise, *judge);
}

void MotionChoice::choose(bool by_wheels) {
  by_wheels_ = by_wheels;
  restart_judging();
}

void MotionChoice::predict(Belief& belief, std::int64_t to) {
  if (judge_ && by_wheels_ && judge_->following()) {
    Hypothesis all = moments(belief.mixture, now().angle());
    history_.replay(belief.utime, to, [&](const WheelMotion& piece) {
      judge_->moved(all.mean, piece);
      advance(all, piece, judge_->believed());
    });
  }
  belief.predict(now(), to);
}

void MotionChoice::judge(const Hypothesis& before, const Hypothesis& after, const AntennaView& view) {
  if (!judge_ || !by_wheels_) return;
  judge_->matched(before, after, view.H);
  wheels_.set_noise(judge_->believed());
}

void MotionChoice::restart_judging() {
  if (judge_) judge_->restart();
}

WheelJudgement MotionChoice::judgement() const {
  return judge_ ? judge_->judgement() : WheelJudgement{};
}

}  // namespace markservo::rfid_localizer
