#pragma once

// DRIVE, before figure 11 or alone: the arm folds, the base brings the robot to where it can take the target, or was
// told to, and stands.

#include <cstdint>
#include <optional>
#include <string>

#include "services/task-manager/phases/move_sequence.hpp"
#include "services/task-manager/phases/phase_context.hpp"
#include "services/task-manager/watches/drive_watch.hpp"

namespace markservo::task_manager {

struct Transition;

class Drive {
 public:
  static constexpr Phase kPhase = Phase::kDrive;

  // A drive to the commanded pose, once the arm is folded.
  static Drive to(const geometry::PlanePose& X_WG) { return Drive(Stage::kMakingReady, false, X_WG); }
  // A drive on from where the robot stands, the arm still folded.
  static Drive on_by(const geometry::PlanePose& X_RG) { return Drive(Stage::kDriving, true, X_RG); }

  void begin(PhaseContext& context);
  std::optional<Transition> step(PhaseContext& context);

  bool waits_for_first_word() const { return stage_ == Stage::kMakingReady; }
  bool is_driving() const { return stage_ == Stage::kDriving; }

 private:
  enum class Stage {
    kMakingReady,  // waiting for the first word of the arm and the stop devices
    kFolding,      // the arm comes home: stretched out, it would hit what no sonar sees
    kDriving,
    kStanding,  // arrived: the robot swings out
  };

  Drive(Stage stage, bool from_robot, const geometry::PlanePose& pose)
      : stage_(stage), from_robot_(from_robot), pose_(pose) {}

  std::optional<Transition> make_ready(PhaseContext& context);
  std::optional<Transition> fold(PhaseContext& context);
  std::optional<Transition> watch(PhaseContext& context);
  void set_off(PhaseContext& context);
  static Transition arrived(const PhaseContext& context);

  Stage stage_;
  bool from_robot_;  // `pose_` is X_RG, else X_WG
  geometry::PlanePose pose_;
  std::int64_t since_ = 0;  // us, begin of the stage
  MoveSequence folding_;
  DriveProgress progress_;
  std::string words_;  // where to, for people
};

}  // namespace markservo::task_manager
