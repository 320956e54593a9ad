// The node on an in-process bus, answered by a stand-in for the robot.

#include "services/task-operator/task_operator_node.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <markservo/ServiceStatus.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <vector>

#include "common/robot/configuration_error.hpp"
#include "common/robot/robot_description.hpp"
#include "tests/unit/bus/memq_bus.hpp"

namespace markservo::task_operator {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

const std::string kRobotFile = std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml";

class OperatorOnABus : public ::testing::Test {
 protected:
  OperatorOnABus()
      : bus_(bus::memq_parameters("task-operator")),
        stop_states_(bus_.advertise(channels::kStopState)),
        task_states_(bus_.advertise(channels::kTaskState)) {
    bus_.on_each(channels::kStop, [this](const StopRequest& request) { answer(request); });
    bus_.on_each(channels::kTaskCommand, [this](const TaskCommand& command) { answer(command); });
    bus_.every(std::chrono::milliseconds(20), [this] { speak(); });
    bus_.every(std::chrono::seconds(60), [this] { bus_.stop(); });  // only a failure waits so long
  }

  // The exit code of `task-operator WORDS`, typed as `program`.
  int run(std::vector<std::string> words, const std::string& program = "scripts/task") {
    CLI::App app;
    TaskOperatorNode node(program);
    node.add_options(app);
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
    node.configure(kRobotFile);
    node.start(bus_);
    node.run(bus_);
    return node.exit_code();
  }

  // What it says on the standard error when nobody obeys. Once a test, as run(): the bus outlives the node.
  std::string complaint(const std::string& program = "scripts/task") {
    obeys_ = false;
    ::testing::internal::CaptureStderr();
    EXPECT_EQ(run({"stop", "--patience", "0.3"}, program), task::kExitNoAnswer);
    return ::testing::internal::GetCapturedStderr();
  }

  bool latched_ = true;
  std::vector<std::string> services_;  // who speaks there too
  int deaf_to_ = 0;                    // requests that get lost
  bool obeys_ = true;
  std::vector<std::int8_t> procedure_;  // states that follow one after the other once a command came
  std::vector<StopRequest> requests_;
  std::vector<TaskCommand> commands_;

 private:
  void answer(const StopRequest& request) {
    requests_.push_back(request);
    if (deaf_to_-- > 0 || !obeys_) return;
    stop_.request_session = request.session;
    stop_.request_id = request.request_id;
    latched_ = request.kind == StopRequest::STOP;
  }
  void answer(const TaskCommand& command) {
    commands_.push_back(command);
    if (deaf_to_-- > 0) return;
    task_.command_session = command.session;
    task_.command_id = command.command_id;
    task_.target = command.target;
  }
  void speak() {
    utime_ += 20'000;
    stop_.utime = task_.utime = task_.frame_utime = utime_;
    for (const std::string& device : devices_) {
      stop_.device = device;
      stop_.latched = latched_ ? 1 : 0;
      stop_states_.publish(stop_);
    }
    if (task_.command_session != 0 && !procedure_.empty()) {
      task_.state = procedure_.front();
      if (procedure_.size() > 1) procedure_.erase(procedure_.begin());
    }
    task_states_.publish(task_);
    for (const std::string& service : services_) tell_status(service);
  }
  void tell_status(const std::string& service) {
    ServiceStatus status{};
    status.name = service;
    status.session = 77;
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(status.getEncodedSize()));
    status.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
    bus_.publish_raw(channels::kServiceStatus.name, bytes.data(), bytes.size());
  }

  const std::vector<std::string> devices_ = robot::load_robot_description(kRobotFile).stop_devices;
  bus::Bus bus_;
  bus::Publisher<StopState> stop_states_;
  bus::Publisher<TaskState> task_states_;
  StopState stop_{};
  TaskState task_{};
  std::int64_t utime_ = 1'000'000;
};

TEST_F(OperatorOnABus, StopLatchesTheArmAndSaysWhoAsked) {
  latched_ = false;
  EXPECT_EQ(run({"stop", "--source", "a person"}), task::kExitReached);
  EXPECT_TRUE(latched_);
  ASSERT_FALSE(requests_.empty());
  EXPECT_EQ(requests_[0].kind, StopRequest::STOP);
  EXPECT_EQ(requests_[0].source, "a person");
}

TEST_F(OperatorOnABus, ALostResetIsSentAgainAsTheSameRequest) {
  deaf_to_ = 2;
  EXPECT_EQ(run({"reset"}), task::kExitReached);
  EXPECT_FALSE(latched_);
  ASSERT_GE(requests_.size(), 3U);
  EXPECT_EQ(requests_[2].kind, StopRequest::RESET);
  EXPECT_EQ(requests_[2].session, requests_[0].session);
  EXPECT_EQ(requests_[2].request_id, requests_[0].request_id);
}

TEST_F(OperatorOnABus, StartSendsTheTargetAndFollowsTheTaskToItsEnd) {
  latched_ = false;
  deaf_to_ = 1;
  procedure_ = {TaskState::LOOK, TaskState::SERVO, TaskState::CARRY, TaskState::DONE};
  EXPECT_EQ(run({"start", "--target", "blue_book", "--carry"}), task::kExitReached);
  ASSERT_GE(commands_.size(), 2U);
  EXPECT_EQ(commands_[0].kind, TaskCommand::START);
  EXPECT_EQ(commands_[0].target, "blue_book");
  EXPECT_TRUE(commands_[0].carry);
  EXPECT_EQ(commands_[1].command_id, commands_[0].command_id);
}

TEST_F(OperatorOnABus, StartWithADriveSendsThePoseInRadiansAndFollowsIt) {
  latched_ = false;
  procedure_ = {TaskState::DRIVE, TaskState::DRIVE, TaskState::LOOK, TaskState::HOLD_LIFTED};
  EXPECT_EQ(run({"start", "--target", "red_book", "--drive", "-0.2,1.05,90"}), task::kExitReached);
  ASSERT_FALSE(commands_.empty());
  EXPECT_TRUE(commands_[0].drive);
  EXPECT_EQ(commands_[0].drive_pose.x, -0.2);
  EXPECT_EQ(commands_[0].drive_pose.y, 1.05);
  EXPECT_NEAR(commands_[0].drive_pose.heading, 1.5708, 1e-4);
}

TEST_F(OperatorOnABus, DriveSendsThePoseAloneAndFollowsIt) {
  latched_ = false;
  procedure_ = {TaskState::DRIVE, TaskState::DRIVE, TaskState::DONE};
  EXPECT_EQ(run({"drive", "-0.2,1.05,90"}), task::kExitReached);
  ASSERT_FALSE(commands_.empty());
  EXPECT_EQ(commands_[0].kind, TaskCommand::DRIVE);
  EXPECT_EQ(commands_[0].target, "");
  EXPECT_EQ(commands_[0].drive_pose.x, -0.2);
  EXPECT_NEAR(commands_[0].drive_pose.heading, 1.5708, 1e-4);
}

TEST_F(OperatorOnABus, StartWithoutADriveStandsWhereItIs) {
  latched_ = false;
  procedure_ = {TaskState::HOLD_LIFTED};
  EXPECT_EQ(run({"start", "--target", "red_book"}), task::kExitReached);
  ASSERT_FALSE(commands_.empty());
  EXPECT_FALSE(commands_[0].drive);
}

TEST_F(OperatorOnABus, AFailedTaskIsExitCodeOne) {
  latched_ = false;
  procedure_ = {TaskState::LOOK, TaskState::FAILED};
  EXPECT_EQ(run({"start", "--target", "red_book"}), task::kExitRefused);
}

TEST_F(OperatorOnABus, StartReleasesNoStop) {
  EXPECT_EQ(run({"start", "--target", "red_book"}), task::kExitRefused);
  EXPECT_TRUE(latched_);
  EXPECT_TRUE(commands_.empty());
  EXPECT_TRUE(requests_.empty());
}

TEST_F(OperatorOnABus, AnArmThatDoesNotObeyIsExitCodeFour) {
  obeys_ = false;
  EXPECT_EQ(run({"stop", "--patience", "0.3"}), task::kExitNoAnswer);
}

TEST_F(OperatorOnABus, WhereNobodyObeysItSaysWhoSpeaksThere) {
  services_ = {"simulator", "mark-detector"};
  EXPECT_THAT(complaint(), EndsWith("; asked on memq://, where mark-detector and simulator speak\n"));
}

TEST_F(OperatorOnABus, WhereNobodySpeaksItSaysSo) {
  EXPECT_THAT(complaint(), HasSubstr("; asked on memq://, where no service speaks: "));
}

TEST_F(OperatorOnABus, ComplainsInTheNameThatWasTyped) {
  EXPECT_THAT(complaint("markservo task"), StartsWith("task: no answer from "));
}

TEST_F(OperatorOnABus, StartedByItsPathItComplainsInItsOwnName) {
  EXPECT_THAT(complaint("build/release/bin/task-operator"), StartsWith("task-operator: no answer from "));
}

TEST_F(OperatorOnABus, HomeSendsItsKind) {
  latched_ = false;
  procedure_ = {TaskState::GO_HOME, TaskState::DONE};
  EXPECT_EQ(run({"home"}), task::kExitReached);
  ASSERT_FALSE(commands_.empty());
  EXPECT_EQ(commands_[0].kind, TaskCommand::HOME);
}

TEST_F(OperatorOnABus, AbortSendsItsKind) {
  procedure_ = {TaskState::STOPPED};
  EXPECT_EQ(run({"abort"}), task::kExitReached);
  ASSERT_FALSE(commands_.empty());
  EXPECT_EQ(commands_[0].kind, TaskCommand::ABORT);
}

TEST_F(OperatorOnABus, UnknownTargetsAndActionsAreRefusedBeforeAnythingIsSent) {
  EXPECT_THROW(run({"start"}), ConfigurationError);
  EXPECT_THROW(run({"start", "--target", "hand"}), ConfigurationError);
  EXPECT_THROW(run({"home", "--target", "red_book"}), ConfigurationError);
  EXPECT_THROW(run({"jump"}), CLI::ValidationError);
}

TEST_F(OperatorOnABus, APoseThatIsNoneIsRefusedBeforeAnythingIsSent) {
  latched_ = false;
  const auto start = [this](const std::string& pose) {
    return run({"start", "--target", "red_book", "--drive", pose});
  };
  EXPECT_THROW(start("1.0,2.0"), CLI::ParseError);
  EXPECT_THROW(start("1.0,2.0,3.0,4.0"), CLI::ParseError);
  EXPECT_THROW(start("1.0,here,90"), CLI::ParseError);
  EXPECT_THROW(start("1.0,nan,90"), ConfigurationError);
  EXPECT_THROW(run({"home", "--drive", "1,2,90"}), ConfigurationError);
  EXPECT_THROW(run({"drive"}), ConfigurationError);
  EXPECT_THROW(run({"drive", "1,nan,90"}), ConfigurationError);
  EXPECT_THROW(run({"drive", "1,2"}), CLI::ParseError);
  EXPECT_THROW(run({"home", "1,2,90"}), ConfigurationError);
  EXPECT_THROW(run({"drive", "1,2,90", "--target", "red_book"}), ConfigurationError);
  EXPECT_TRUE(commands_.empty());
}

}  // namespace
}  // namespace markservo::task_operator
