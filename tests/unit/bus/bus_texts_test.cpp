// Texts on the bus: refused on receipt, made fit where they are composed; STOP and ABORT are obeyed whatever they say.

#include <chrono>
#include <cstdint>
#include <markservo/StopRequest.hpp>
#include <markservo/TaskCommand.hpp>
#include <markservo/TaskState.hpp>

#include "common/time/clocks.hpp"
#include "tests/unit/bus/bus_fixture.hpp"
#include "tests/unit/encoded.hpp"

namespace markservo::bus {
namespace {

using BusTexts = BusTest;

template <class M>
void deliver(Bus& bus, const std::string& channel, const M& message) {
  const std::vector<std::uint8_t> bytes = test::encoded(message);
  bus.publish_raw(channel, bytes.data(), bytes.size());
  settle(bus);
}

TEST_F(BusTexts, HarmfulTextIsRefusedAndCounted) {
  Bus bus(parameters());
  int handled = 0;
  bus.on_each(channels::kTaskState, [&](const TaskState&) { ++handled; });
  TaskState state{};
  state.session = 7;
  state.seq = 1;
  state.reason = "lifted\n12:00:00 forged";
  deliver(bus, "TASK_STATE", state);
  state.reason = std::string(201, 'x');
  deliver(bus, "TASK_STATE", state);
  EXPECT_EQ(handled, 0);
  EXPECT_EQ(only_channel(bus).refused, 2);
}

TEST_F(BusTexts, ComposedTextIsMadeFitAndSent) {
  Bus bus(parameters());
  std::vector<std::string> reasons;
  bus.on_each(channels::kTaskState, [&](const TaskState& state) { reasons.push_back(state.reason); });
  auto publisher = bus.advertise(channels::kTaskState);
  TaskState state{};
  state.reason = "a long story\n" + std::string(1 << 20, 'x');
  publisher.publish(state);
  settle(bus);
  ASSERT_EQ(reasons.size(), 1U);
  EXPECT_EQ(reasons[0].size(), 200U);
  EXPECT_EQ(reasons[0].substr(0, 14), "a long story x");
}

TEST_F(BusTexts, StopIsObeyedWhateverItSays) {
  Bus bus(parameters());
  std::vector<StopRequest> heard;
  bus.on_each(channels::kStop, [&](const StopRequest& request) { heard.push_back(request); });
  StopRequest stop{};
  stop.session = 7;
  stop.reason = std::string(8 << 20, '\x1b');
  for (const std::int64_t utime : {std::int64_t{0}, std::int64_t{-1}, wall_clock_us() + 3'600'000'000}) {
    stop.utime = utime;
    deliver(bus, "STOP", stop);
  }
  ASSERT_EQ(heard.size(), 3U);
  for (const StopRequest& request : heard) EXPECT_LE(request.reason.size(), 200U);
  stop.kind = StopRequest::RESET;
  deliver(bus, "STOP", stop);
  EXPECT_EQ(heard.size(), 3U) << "RESET of an hour ahead, with such a reason";
  EXPECT_EQ(only_channel(bus).refused, 1);
}

TEST_F(BusTexts, AbortIsObeyedWhateverItSays) {
  Bus bus(parameters());
  int heard = 0;
  bus.on_each(channels::kTaskCommand, [&](const TaskCommand&) { ++heard; });
  TaskCommand abort{};
  abort.session = 7;
  abort.kind = TaskCommand::ABORT;
  abort.utime = wall_clock_us() + 3'600'000'000;
  abort.target = std::string(1 << 20, 'x');
  deliver(bus, "TASK_COMMAND", abort);
  EXPECT_EQ(heard, 1);
}

}  // namespace
}  // namespace markservo::bus
