#pragma once

// What one round of the RFID reader tells of the antenna's whereabouts: its Fisher information.

#include <Eigen/Core>
#include <vector>

#include "tests/experiments/localisation/true_path.hpp"

namespace markservo::experiments {

struct ReaderModel {
  Eigen::Vector2d p_RF = Eigen::Vector2d::Zero();  // m, the antenna's middle in R
  double reading_radius = 0.10;                    // m, where half the reads fail
  double edge_softness = 0.01;                     // m, scale of the logistic edge
  double read_probability = 0.95;                  // of a tag well inside, each round
  double round_time = 0.10;                        // s, one round; the antenna moves on during it
  std::vector<Eigen::Vector2d> tags;               // m in W
};

// Of x, y, heading at the round's middle, and of the delay from there to the round's arrival. The time of arrival is
// what is known: an arrival later by e stands for reads farther back along the way by speed * e.
using ReadInformation = Eigen::Matrix4d;  // 1/m^2, 1/m, 1/s^2 ...

// The expected information of the round whose middle is at `middle` (s), along the true path: the sum over all tags,
// read or not, of gradient gradient^T / (p (1 - p)), with p the probability of a read averaged over the round.
// Throws std::invalid_argument unless radius and softness are above 0, 0 < read_probability <= 1 and round_time >= 0.
ReadInformation read_information(const ReaderModel& reader, const TruePath& path, double middle);

}  // namespace markservo::experiments
