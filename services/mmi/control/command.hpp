#pragma once

#include <cstdint>
#include <string>

#include "common/geometry/plane_pose.hpp"
#include "common/task/dialogue.hpp"

namespace markservo::mmi {

// What an operator wishes.
struct Command {
  task::Action action = task::Action::kAbort;  // never kStop, which everybody may
  std::string target;                          // kStart: whose mark to take
  bool carry = false;                          // kStart: carry it to the side, and go home
  geometry::PlanePose place;                   // kDrive: X_WR, m and rad
};

// The name by which one wish may be sent once: of whom, its number, and until when.
struct CommandStamp {
  std::int64_t session = 0;        // of the conversation
  std::int64_t seq = 0;            // grows
  std::int64_t expires_utime = 0;  // us of this program's clock
};

}  // namespace markservo::mmi
