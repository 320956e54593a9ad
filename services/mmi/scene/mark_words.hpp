#pragma once

// The words by which config/robot.yaml tells what a mark is.

#include "common/robot/robot_description.hpp"

namespace markservo::mmi {

inline const char* word_of(robot::MarkRole role) {
  return role == robot::MarkRole::kTarget ? "target" : "manipulator";
}

inline const char* word_of(robot::MarkSurface surface) {
  switch (surface) {
    case robot::MarkSurface::kPlane:
      return "plane";
    case robot::MarkSurface::kFree:
      return "free";
    case robot::MarkSurface::kBall:
      break;
  }
  return "ball";
}

inline const char* word_of(robot::MarkOutline outline) {
  switch (outline) {
    case robot::MarkOutline::kSquare:
      return "square";
    case robot::MarkOutline::kDisc:
      return "disc";
    case robot::MarkOutline::kOther:
      break;
  }
  return "other";
}

}  // namespace markservo::mmi
