#pragma once

// MuJoCo's arrays of numbers as Eigen's.

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <cstddef>

namespace markservo::simulator {

// Numbers that a vector, a rotation matrix and a quaternion take.
inline constexpr std::ptrdiff_t kVector = 3;
inline constexpr std::ptrdiff_t kMatrix = 9;
inline constexpr std::ptrdiff_t kQuaternion = 4;

inline Eigen::Vector3d vector(const mjtNum* v) {
  return {v[0], v[1], v[2]};
}

// MuJoCo writes matrices row by row.
inline Eigen::Matrix3d matrix(const mjtNum* m) {
  return Eigen::Map<const Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>>(m);
}

}  // namespace markservo::simulator
