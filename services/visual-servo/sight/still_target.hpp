#pragma once

// A mark that mostly stands still: its position is averaged, and followed at once when it has been moved.

#include <Eigen/Core>

namespace markservo::visual_servo {

struct StillTargetParameters {
  int frames = 30;       // averaged over, at most: one second, noise down by five
  double gate = 0.0015;  // m; a sample farther from the mean than this and than 5 sigma does not belong to it
  int moved_frames = 2;  // so many in a row mean that the mark has been moved; one alone is an outlier
};

class StillTarget {
 public:
  // Takes one frame's position (m, in C) with its covariance (m^2).
  void observe(const StillTargetParameters& parameters, const Eigen::Vector3d& p, const Eigen::Matrix3d& covariance);
  void forget() { *this = StillTarget(); }

  bool seen() const { return frames_ > 0; }
  const Eigen::Vector3d& position() const { return mean_; }
  Eigen::Matrix3d covariance() const { return covariance_ / frames_; }

 private:
  int frames_ = 0;
  int outside_ = 0;
  Eigen::Vector3d mean_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_ = Eigen::Matrix3d::Zero();  // of one frame
};

}  // namespace markservo::visual_servo
