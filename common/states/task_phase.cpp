#include "common/states/task_phase.hpp"

#include <array>
#include <cstddef>

namespace markservo {

const char* name_of(TaskPhase phase) {
  constexpr std::array<const char*, 17> kNames = {"idle",   "look",    "approach", "servo",   "grip",    "lift",
                                                  "verify", "lift on", "carry",    "release", "go home", "lifted",
                                                  "done",   "refused", "failed",   "stopped", "drive"};
  return kNames.at(static_cast<std::size_t>(phase));
}

bool under_way(TaskPhase phase) {
  return phase == TaskPhase::kDrive || (phase >= TaskPhase::kLook && phase <= TaskPhase::kGoHome);
}

}  // namespace markservo
