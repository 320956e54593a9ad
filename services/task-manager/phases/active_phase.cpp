#include "services/task-manager/phases/active_phase.hpp"

#include <type_traits>

namespace markservo::task_manager {

Phase phase_of(const ActivePhase& phase) {
  return std::visit([](const auto& active) { return active.kPhase; }, phase);
}

void begin(ActivePhase& phase, PhaseContext& context) {
  std::visit([&context](auto& active) { active.begin(context); }, phase);
}

std::optional<Transition> step(ActivePhase& phase, PhaseContext& context) {
  return std::visit(
      [&context](auto& active) -> std::optional<Transition> {
        if constexpr (std::is_base_of_v<AtRest, std::decay_t<decltype(active)>>) {
          return std::nullopt;
        } else {
          return active.step(context);
        }
      },
      phase);
}

}  // namespace markservo::task_manager
