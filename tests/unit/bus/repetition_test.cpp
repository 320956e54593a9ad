#include <cstdint>

#include "common/bus/repeat_timer.hpp"
#include "tests/unit/bus/bus_fixture.hpp"

namespace markservo::bus {
namespace {

TEST(RepeatTimer, IsDueFiveTimesASecondOfMessageTime) {
  RepeatTimer timer(kStateRepeat_us);
  int sent = 0;
  for (std::int64_t utime = 0; utime < 1'000'000; utime += 10'000) sent += timer.due(utime) ? 1 : 0;
  EXPECT_EQ(sent, 5);
}

TEST(RepeatTimer, IsDueWhenTimeWentBack) {
  RepeatTimer timer(kStateRepeat_us);
  EXPECT_TRUE(timer.due(5'000'000));
  EXPECT_TRUE(timer.due(1'000'000));
}

// What a restarted service relies on: a goal repeated with the same id is heard again without being another goal.
TEST_F(BusTest, LatecomerLearnsARepeatedGoal) {
  Bus bus(parameters());
  auto goals = bus.advertise(made_up<JointState>("GOAL"));
  RepeatTimer timer(kStateRepeat_us);
  auto goal = joint_state(0);
  if (timer.due(0)) goals.publish(goal);  // nobody listens yet
  settle(bus);
  int heard = 0;
  bus.on_each(made_up<JointState>("GOAL"), [&](const JointState&) { ++heard; });
  for (std::int64_t utime = 0; utime <= 400'000; utime += 50'000) {
    if (timer.due(utime)) goals.publish(goal);
  }
  settle(bus);
  EXPECT_EQ(heard, 2);
}

}  // namespace
}  // namespace markservo::bus
