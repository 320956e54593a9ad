#pragma once

// SERVO: the hand comes to the grip point by sight.

#include <cstdint>
#include <optional>

#include "services/task-manager/phases/phase_context.hpp"
#include "services/task-manager/watches/condition_timer.hpp"

namespace markservo::task_manager {

struct Transition;

class Servo {
 public:
  static constexpr Phase kPhase = Phase::kServo;

  enum class Stage {
    kToTheLine,       // of approach, before the objects' fronts
    kToTheGripPoint,  // between the neighbours
  };

  explicit Servo(Stage first) : stage_(first) {}

  void begin(PhaseContext& context) { aim(context); }
  std::optional<Transition> step(PhaseContext& context);

 private:
  void aim(PhaseContext& context);

  Stage stage_;
  std::int64_t since_ = 0;  // us, begin of the stage
  ConditionTimer lost_;
};

}  // namespace markservo::task_manager
