#include "services/stack-watch/incidents.hpp"

#include <gtest/gtest.h>

#include "services/stack-watch/bus_condition.hpp"

namespace markservo::stack_watch {
namespace {

constexpr std::int64_t kSecond_us = 1'000'000;
constexpr std::int64_t kNow_us = 1'700'000'000 * kSecond_us;

TEST(Kills, AreToldForAMinute) {
  Kills kills;
  EXPECT_EQ(kills.told(kNow_us), "");
  kills.add({"visual-servo", 7, 5.4, true, kNow_us});
  EXPECT_EQ(kills.told(kNow_us + 59 * kSecond_us), "visual-servo (pid 7) said nothing for 5 s and was killed");
  EXPECT_EQ(kills.told(kNow_us + 60 * kSecond_us), "");
}

TEST(Kills, KeepTheNewestTwenty) {
  Kills kills;
  for (int pid = 1; pid <= 30; ++pid) kills.add({"visual-servo", pid, 5.0, true, kNow_us});
  ASSERT_EQ(kills.newest().size(), 20U);
  EXPECT_EQ(kills.newest().front().pid, 11);
  EXPECT_EQ(kills.newest().back().pid, 30);
}

TEST(CraftedFragments, AreNewsWhereNoneCameForAMinute) {
  CraftedFragments crafted;
  EXPECT_TRUE(crafted.observe("10.0.0.7:7667", kNow_us));
  EXPECT_FALSE(crafted.observe("10.0.0.8:7667", kNow_us + 50 * kSecond_us));
  EXPECT_FALSE(crafted.observe("10.0.0.8:7667", kNow_us + 100 * kSecond_us)) << "a stream goes on";
  EXPECT_EQ(crafted.told(kNow_us + 101 * kSecond_us), "3 crafted fragments came, the last from 10.0.0.8:7667");
  EXPECT_EQ(crafted.told(kNow_us + 160 * kSecond_us), "");
  EXPECT_TRUE(crafted.observe("10.0.0.7:7667", kNow_us + 161 * kSecond_us));
  EXPECT_EQ(crafted.count(), 4);
}

TEST(BusCondition, ChangesWhenTheBusGoesAndComes) {
  BusCondition bus;
  EXPECT_FALSE(bus.observe("", kNow_us)) << "it was there from the beginning";
  EXPECT_TRUE(bus.observe("own messages do not come back", kNow_us + kSecond_us));
  EXPECT_FALSE(bus.observe("it cannot be joined", kNow_us + 2 * kSecond_us));
  EXPECT_EQ(bus.problem(), "it cannot be joined");
  EXPECT_EQ(bus.changed_us(), kNow_us + kSecond_us);
  EXPECT_TRUE(bus.observe("", kNow_us + 3 * kSecond_us));
  EXPECT_FALSE(bus.is_gone());
}

}  // namespace
}  // namespace markservo::stack_watch
