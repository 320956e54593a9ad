#include "common/messages/state_codes.hpp"

#include <markservo/BaseStatus.hpp>
#include <markservo/LocatedMark.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/TaskState.hpp>

#include "common/states/base_state.hpp"
#include "common/states/localisation_state.hpp"
#include "common/states/mark_cue.hpp"
#include "common/states/mark_status.hpp"
#include "common/states/servo_state.hpp"
#include "common/states/task_phase.hpp"

namespace markservo::messages {
namespace {

static_assert(code_of(ServoState::kHold) == ServoStatus::HOLD);
static_assert(code_of(ServoState::kPosture) == ServoStatus::POSTURE);
static_assert(code_of(ServoState::kServo) == ServoStatus::SERVO);
static_assert(code_of(ServoState::kConverged) == ServoStatus::CONVERGED);
static_assert(code_of(ServoState::kLost) == ServoStatus::LOST);
static_assert(code_of(ServoState::kUnreachable) == ServoStatus::UNREACHABLE);
static_assert(code_of(ServoState::kStale) == ServoStatus::STALE);
static_assert(code_of(ServoState::kStopped) == ServoStatus::STOPPED);

static_assert(code_of(BaseState::kHold) == BaseStatus::HOLD);
static_assert(code_of(BaseState::kDriving) == BaseStatus::DRIVING);
static_assert(code_of(BaseState::kArrived) == BaseStatus::ARRIVED);
static_assert(code_of(BaseState::kBlocked) == BaseStatus::BLOCKED);
static_assert(code_of(BaseState::kLost) == BaseStatus::LOST);
static_assert(code_of(BaseState::kStale) == BaseStatus::STALE);
static_assert(code_of(BaseState::kStopped) == BaseStatus::STOPPED);

static_assert(code_of(LocalisationState::kSearching) == RobotPose::SEARCHING);
static_assert(code_of(LocalisationState::kLocalised) == RobotPose::LOCALISED);
static_assert(code_of(LocalisationState::kLost) == RobotPose::LOST);

static_assert(code_of(MarkStatus::kLocated) == LocatedMark::LOCATED);
static_assert(code_of(MarkStatus::kUnseen) == LocatedMark::UNSEEN);
static_assert(code_of(MarkStatus::kSeenByOne) == LocatedMark::SEEN_BY_ONE);
static_assert(code_of(MarkStatus::kClipped) == LocatedMark::CLIPPED);
static_assert(code_of(MarkStatus::kTooFewMatches) == LocatedMark::TOO_FEW_MATCHES);
static_assert(code_of(MarkStatus::kInconsistent) == LocatedMark::INCONSISTENT);

static_assert(code_of(MarkCue::kNone) == LocatedMark::CUE_NONE);
static_assert(code_of(MarkCue::kTexture) == LocatedMark::CUE_TEXTURE);
static_assert(code_of(MarkCue::kOutline) == LocatedMark::CUE_OUTLINE);
static_assert(code_of(MarkCue::kCentroid) == LocatedMark::CUE_CENTROID);

static_assert(code_of(TaskPhase::kIdle) == TaskState::IDLE);
static_assert(code_of(TaskPhase::kLook) == TaskState::LOOK);
static_assert(code_of(TaskPhase::kApproach) == TaskState::APPROACH);
static_assert(code_of(TaskPhase::kServo) == TaskState::SERVO);
static_assert(code_of(TaskPhase::kGrip) == TaskState::GRIP);
static_assert(code_of(TaskPhase::kLift) == TaskState::LIFT);
static_assert(code_of(TaskPhase::kVerify) == TaskState::VERIFY);
static_assert(code_of(TaskPhase::kLiftOn) == TaskState::LIFT_ON);
static_assert(code_of(TaskPhase::kCarry) == TaskState::CARRY);
static_assert(code_of(TaskPhase::kRelease) == TaskState::RELEASE);
static_assert(code_of(TaskPhase::kGoHome) == TaskState::GO_HOME);
static_assert(code_of(TaskPhase::kHoldLifted) == TaskState::HOLD_LIFTED);
static_assert(code_of(TaskPhase::kDone) == TaskState::DONE);
static_assert(code_of(TaskPhase::kRefused) == TaskState::REFUSED);
static_assert(code_of(TaskPhase::kFailed) == TaskState::FAILED);
static_assert(code_of(TaskPhase::kStopped) == TaskState::STOPPED);
static_assert(code_of(TaskPhase::kDrive) == TaskState::DRIVE);

static_assert(code_of(TaskResult::kNone) == TaskState::RESULT_NONE);
static_assert(code_of(TaskResult::kLifted) == TaskState::RESULT_LIFTED);
static_assert(code_of(TaskResult::kRefused) == TaskState::RESULT_REFUSED);
static_assert(code_of(TaskResult::kFailed) == TaskState::RESULT_FAILED);

}  // namespace
}  // namespace markservo::messages
