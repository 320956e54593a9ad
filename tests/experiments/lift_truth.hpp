#pragma once

// What the simulator's truth says of bodies and marks: the one judge of every experiment.

#include <Eigen/Core>
#include <markservo/SimBody.hpp>
#include <markservo/SimTruth.hpp>
#include <optional>
#include <string>

namespace markservo::experiments {

inline constexpr double kLiftedHeight = 0.020;  // m, above where it stood

inline Eigen::Vector3d vector(const Vector3& v) {
  return {v.x, v.y, v.z};
}

// The body that carries the mark `name`; nullptr if there is none.
inline const SimBody* find_body(const SimTruth& truth, const std::string& name) {
  for (const auto& body : truth.bodies) {
    if (body.name == name) return &body;
  }
  return nullptr;
}

// True if the body hangs in the air between both fingers and touches nothing else.
inline bool held_free(const SimBody& body) {
  return body.height_gain >= kLiftedHeight && body.touches_left_finger && body.touches_right_finger &&
         !body.touches_other;
}

// The true centre of the mark `name` in C, m.
inline std::optional<Eigen::Vector3d> true_mark(const SimTruth& truth, const std::string& name) {
  for (const auto& mark : truth.marks) {
    if (mark.name == name) return vector(mark.p_C);
  }
  return std::nullopt;
}

}  // namespace markservo::experiments
