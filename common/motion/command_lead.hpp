#pragma once

// How far a command may lead the shafts it moves: what is farther was made from a wrong idea of where they are.

#include <cmath>
#include <cstddef>
#include <optional>

namespace markservo::motion {

struct CommandLead {
  double seconds = 0.3;    // of the way at the command's own speed limit: a mover that follows is never farther behind
  double allowance = 0.1;  // rad: deadband, backlash and a servo's lag at low speed
};

// The first joint whose commanded position (rad) leads the shaft's (rad) by more than `lead` allows at the command's
// speed limit (rad/s); nothing when none does. The three hold one number a joint.
template <class Vector>
std::optional<std::size_t> leading_joint(const Vector& commanded, const Vector& speed_limit, const Vector& shaft,
                                         const CommandLead& lead = {}) {
  for (std::size_t joint = 0; joint < static_cast<std::size_t>(commanded.size()); ++joint) {
    const auto i = static_cast<decltype(commanded.size())>(joint);
    if (std::abs(commanded[i] - shaft[i]) > lead.seconds * speed_limit[i] + lead.allowance) return joint;
  }
  return std::nullopt;
}

}  // namespace markservo::motion
