#include "services/mmi/live_source_node.hpp"

#include <gtest/gtest.h>

#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>
#include <thread>

#include "common/time/clocks.hpp"
#include "tests/unit/bus/memq_bus.hpp"
#include "tests/unit/mmi/robot_of_the_project.hpp"

namespace markservo::mmi {
namespace {

class ShownBus : public ::testing::Test {
 protected:
  ShownBus() : bus_(parameters()), source_(robot_of_the_project(), "") {
    source_.start(bus_);
    bus_.on_each(channels::kStop, [this](const StopRequest& stop) { stops_.push_back(stop); });
    states_.emplace(bus_.advertise(channels::kStopState));
  }

  static bus::BusParameters parameters() {
    bus::BusParameters parameters = bus::memq_parameters("mmi");
    parameters.robot = "r2";
    return parameters;
  }

  // Time passes, by the clock: 0.25 s or more, in which a STOP is repeated that is not echoed.
  void pass() {
    for (int i = 0; i < 25; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      source_.tick();
      bus::settle(bus_);
    }
  }

  void say(const std::string& device, const StopRequest& obeyed = {}) {
    StopState state{};
    state.utime = utime_ += 1000;
    state.device = device;
    state.latched = obeyed.request_id > 0 ? 1 : 0;
    state.request_session = obeyed.session;
    state.request_id = obeyed.request_id;
    if (state.latched != 0) state.reason = obeyed.source + ": " + obeyed.reason;
    states_->publish(state);
    bus::settle(bus_);
  }
  void echo(const std::string& device) { say(device, stops_.back()); }

  void reset() {
    StopRequest reset{};
    reset.utime = utime_ += 1000;
    reset.session = 99;
    reset.request_id = 1;
    reset.kind = StopRequest::RESET;
    bus_.advertise(channels::kStop).publish(reset);
    bus::settle(bus_);
    stops_.pop_back();  // not one of ours
  }

  bus::Bus bus_;
  LiveSourceNode source_;
  std::vector<StopRequest> stops_;
  std::optional<bus::Publisher<StopState>> states_;
  std::int64_t utime_ = 1'600'000'000'000'000;
};

TEST_F(ShownBus, IsHeardWholeWithoutTheRobotsPrefix) {
  TaskState task{};
  task.utime = utime_;
  task.frame_utime = utime_;
  task.frame_session = 1;
  task.frame_seq = 1;
  auto publisher = bus_.advertise(channels::kTaskState);
  publisher.publish(task);
  const char any[] = "whatever this is";
  bus_.publish_raw("A_CHANNEL_OF_OTHERS", any, sizeof any);
  bus::settle(bus_);
  EXPECT_NE(source_.world().slots().find("TASK_STATE", ""), nullptr);
  EXPECT_NE(source_.world().slots().find("A_CHANNEL_OF_OTHERS", ""), nullptr);
}

TEST_F(ShownBus, IsStoppedAtOnceAndUntilEveryDeviceHasEchoed) {
  source_.stop("smoke");
  bus::settle(bus_);
  ASSERT_EQ(stops_.size(), 1U);
  EXPECT_EQ(stops_[0].kind, StopRequest::STOP);
  EXPECT_EQ(stops_[0].source, "page");
  EXPECT_EQ(stops_[0].reason, "smoke");
  EXPECT_EQ(stops_[0].session, bus_.session());
  pass();
  const std::size_t repeated = stops_.size();
  EXPECT_GT(repeated, 1U);
  echo("arm");
  pass();
  EXPECT_GT(stops_.size(), repeated);
  echo("base");
  const std::size_t echoed = stops_.size();
  pass();
  EXPECT_EQ(stops_.size(), echoed);
  EXPECT_NE(source_.stop_state().text.find("acknowledged"), std::string::npos);
}

TEST_F(ShownBus, IsNotStoppedAnyMoreOnceSomebodyResets) {
  say("arm");
  say("base");
  source_.stop("smoke");
  bus::settle(bus_);
  reset();
  const std::size_t before = stops_.size();
  pass();
  EXPECT_EQ(stops_.size(), before);
}

TEST_F(ShownBus, HasNoTimeToTurnBack) {
  EXPECT_NE(source_.shown()->control(ClientPause{}), "");
}

TEST_F(ShownBus, ObeysNobodyWithoutAToken) {
  EXPECT_EQ(source_.desk(), nullptr);
}

class CommandedBus : public ShownBus {
 protected:
  CommandedBus() : commanded_(robot_of_the_project(), "", {}, "a token of commands") {
    commanded_.start(bus_);
    bus_.on_each(channels::kTaskCommand, [this](const TaskCommand& command) { commands_.push_back(command); });
    desk().arrive(kPage);
    desk().hear_token(kPage, "a token of commands");
    desk().lease(kPage, true, false, steady_seconds());
  }

  Desk& desk() { return *commanded_.desk(); }
  void wish(task::Action action) {
    Command command;
    command.action = action;
    command.target = "red_book";
    command.place = {0.5, 1.0, 0.25};
    const std::int64_t now = wall_clock_us();
    desk().command(kPage, {kPage, ++seq_, now + 1'000'000}, command, steady_seconds(), now);
    commanded_.tick();
    bus::settle(bus_);
  }
  void say_task(std::int8_t state) {
    TaskState task{};
    task.utime = utime_ += 1000;
    task.session = 9;
    task.seq = ++task_seq_;
    task.frame_session = 1;
    task.frame_seq = task.seq;
    task.frame_utime = task.utime;
    task.state = state;
    bus_.advertise(channels::kTaskState).publish(task);
    bus::settle(bus_);
  }

  static constexpr std::int64_t kPage = 101;
  LiveSourceNode commanded_;
  std::vector<TaskCommand> commands_;
  std::int64_t seq_ = 0;
  std::int64_t task_seq_ = 0;
};

TEST_F(CommandedBus, IsToldWhereToDriveUnderItsOwnSession) {
  say("arm");
  say("base");
  say_task(TaskState::IDLE);
  wish(task::Action::kDrive);
  ASSERT_EQ(commands_.size(), 1U) << desk().take_answers(kPage);
  EXPECT_EQ(commands_[0].kind, TaskCommand::DRIVE);
  EXPECT_EQ(commands_[0].session, bus_.session());
  EXPECT_EQ(commands_[0].drive_pose.x, 0.5);
  EXPECT_EQ(commands_[0].utime, utime_);
}

TEST_F(CommandedBus, IsResetUnderANumberOfItsOwn) {
  commanded_.stop("smoke");
  bus::settle(bus_);
  const StopRequest stop = stops_.back();
  say("arm", stop);
  say("base", stop);
  wish(task::Action::kReset);
  EXPECT_TRUE(commands_.empty());
  ASSERT_EQ(stops_.size(), 2U) << desk().take_answers(kPage);
  EXPECT_EQ(stops_[1].kind, StopRequest::RESET);
  EXPECT_EQ(stops_[1].request_id, stop.request_id + 1);
}

}  // namespace
}  // namespace markservo::mmi
