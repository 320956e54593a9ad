#pragma once

// What one writer has commanded so far, and whether its next command continues it. A writer goes on from its own last
// command, at the speed that it tells: what jumps is of another that writes in its name, and moves nothing.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "common/time/seconds_between.hpp"

namespace markservo::motion {

struct CommandPathParameters {
  double short_step = 0.035;  // rad, told at any speed: a deadband is left in one such step
  double allowance = 0.01;    // rad beyond the told speed: a frame that came early
  double at_shaft = 0.03;     // rad; so near to the shafts a command moves nothing: its writer takes them as they are
};

class CommandPath {
 public:
  explicit CommandPath(CommandPathParameters parameters = {}) : parameters_(parameters) {}

  // The first joint whose commanded position (rad) lies farther from the last command that was followed than
  // `speed_limit` (rad/s) allows in the time between the two measurements that they answer; nothing when none does,
  // when all are where the shafts (rad) are, or before the first. `utime`: us, of the measurement that it answers. The
  // three hold one number a joint.
  template <class Vector>
  std::optional<std::size_t> jumping_joint(const Vector& commanded, const Vector& speed_limit, const Vector& shaft,
                                           std::int64_t utime) const {
    if (last_.size() != static_cast<std::size_t>(commanded.size())) return std::nullopt;
    const double seconds = std::max(0.0, seconds_between(utime_, utime));
    std::optional<std::size_t> jumping;
    bool moves = false;
    for (std::size_t joint = 0; joint < last_.size(); ++joint) {
      const auto i = static_cast<decltype(commanded.size())>(joint);
      moves = moves || std::abs(commanded[i] - shaft[i]) > parameters_.at_shaft;
      const double allowed = std::max(parameters_.short_step, speed_limit[i] * seconds + parameters_.allowance);
      if (!jumping && std::abs(commanded[i] - last_[joint]) > allowed) jumping = joint;
    }
    return moves ? jumping : std::nullopt;
  }

  // The mover follows `commanded` (rad) from now on.
  template <class Vector>
  void follow(const Vector& commanded, std::int64_t utime) {
    last_.assign(commanded.data(), commanded.data() + commanded.size());
    utime_ = utime;
  }

  // The mover stands: the next command may begin anywhere near its shafts.
  void forget() { last_.clear(); }

 private:
  CommandPathParameters parameters_;
  std::vector<double> last_;  // rad; empty before the first
  std::int64_t utime_ = 0;    // us
};

}  // namespace markservo::motion
