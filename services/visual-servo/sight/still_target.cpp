#include "services/visual-servo/sight/still_target.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::visual_servo {

void StillTarget::observe(const StillTargetParameters& parameters, const Eigen::Vector3d& p,
                          const Eigen::Matrix3d& covariance) {
  constexpr double kSigmas = 5.0;
  const double sigma = std::sqrt(std::max(0.0, covariance.trace()));
  const bool outside = frames_ > 0 && (p - mean_).norm() > std::max(parameters.gate, kSigmas * sigma);
  outside_ = outside ? outside_ + 1 : 0;
  if (outside && outside_ < parameters.moved_frames) return;
  if (outside) frames_ = outside_ = 0;
  frames_ = std::min(frames_ + 1, parameters.frames);
  mean_ += (p - mean_) / frames_;
  covariance_ += (covariance - covariance_) / frames_;
}

}  // namespace markservo::visual_servo
