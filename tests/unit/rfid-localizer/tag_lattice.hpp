#pragma once

// Fields of floor tags for tests.

#include <cstdio>

#include "common/robot/robot_description.hpp"

namespace markservo::rfid_localizer::test {

inline std::string uid_of(int number) {
  char uid[17];
  std::snprintf(uid, sizeof uid, "E0040150%08X", static_cast<unsigned int>(number));
  return uid;
}

// `columns` x `rows` tags `spacing` (m) apart; number 0 at `corner` (m in W), counted along x, then y.
inline robot::TagField lattice(int columns, int rows, double spacing,
                               const Eigen::Vector2d& corner = Eigen::Vector2d::Zero()) {
  robot::TagField field;
  field.name = "lattice";
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      field.tags.push_back({uid_of(row * columns + column), corner + Eigen::Vector2d(column * spacing, row * spacing)});
    }
  }
  return field;
}

}  // namespace markservo::rfid_localizer::test
