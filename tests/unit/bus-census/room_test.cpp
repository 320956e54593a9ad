// When services may be started on a bus that others are on.

#include "services/bus-census/room.hpp"

#include <gtest/gtest.h>

#include <cstdint>

namespace markservo::bus_census {
namespace {

using census::ChannelReport;
using census::Report;
using census::ServiceReport;

constexpr int kPid = 41;
constexpr std::int64_t kSession = 7;

// A bus on which `service` speaks and writes `channel`.
Report bus_with(const std::string& service, const std::string& channel, const std::string& robot = "") {
  Report report;
  ServiceReport process;
  process.newest.robot = robot;
  process.newest.name = service;
  process.newest.host = "here";
  process.newest.pid = kPid;
  process.newest.session = kSession;
  report.services.push_back(process);
  if (channel.empty()) return report;
  ChannelReport line;
  line.channel = (robot.empty() ? "" : robot + "/") + channel;
  line.events = 5;
  line.writers.push_back({kSession, service, 5});
  report.channels.push_back(line);
  return report;
}

RoomWish wish_for(const std::string& service) {
  RoomWish wish;
  wish.services = {service};
  wish.robot = "";
  wish.host = "here";
  return wish;
}

using Lines = std::vector<std::string>;

TEST(Room, IsOnAnEmptyBus) {
  EXPECT_EQ(obstacles({}, wish_for("simulator")), Lines{});
}

TEST(Room, IsNotWhereWhatOneAloneMayWriteIsWritten) {
  EXPECT_EQ(obstacles(bus_with("arm-driver", "JOINT_STATE"), wish_for("simulator")),
            Lines{"arm-driver (process 41 on here) writes JOINT_STATE"});
}

TEST(Room, IsWhereOnesOwnProcessWritesThatHasNotSpokenYet) {
  Report report = bus_with("simulator", "JOINT_STATE");
  report.services.clear();
  RoomWish wish = wish_for("simulator");
  EXPECT_TRUE(somebody_is_unknown(report, wish));
  wish.own_sessions = {kSession};
  EXPECT_FALSE(somebody_is_unknown(report, wish));
  EXPECT_EQ(obstacles(report, wish), Lines{});
}

TEST(Room, IsWhereAnotherClaimsTheSessionOfOnesOwnProcess) {
  Report report = bus_with("simulator", "JOINT_STATE");
  report.services.insert(report.services.begin(), report.services[0]);
  report.services[0].newest.name = "liar";
  report.services[0].newest.pid = 1;
  RoomWish wish = wish_for("simulator");
  wish.own = {kPid};
  EXPECT_EQ(obstacles(report, wish), Lines{});
}

TEST(Room, IsNotBesideAWriterWhoDoesNotSayWhoItIs) {
  Report report = bus_with("arm-driver", "JOINT_STATE");
  report.services.clear();
  EXPECT_EQ(obstacles(report, wish_for("simulator")),
            Lines{"a program that does not say who it is writes JOINT_STATE"});
  report.channels[0].writers.clear();  // its messages cannot be decoded
  EXPECT_EQ(obstacles(report, wish_for("simulator")),
            Lines{"a program that does not say who it is writes JOINT_STATE"});
}

TEST(Room, IsNotBesideTheSameServiceEvenIfItHasWrittenNothingYet) {
  EXPECT_EQ(obstacles(bus_with("mark-detector", ""), wish_for("mark-detector")),
            Lines{"mark-detector (process 41 on here) runs already: it alone may write MARK_DETECTION"});
}

TEST(Room, NamesAnObstacleOnceWithAllItsChannels) {
  Report report = bus_with("simulator", "JOINT_STATE");
  report.channels.push_back(report.channels[0]);
  report.channels.back().channel = "STEREO_FRAME";
  EXPECT_EQ(obstacles(report, wish_for("simulator")),
            Lines{"simulator (process 41 on here) writes JOINT_STATE, STEREO_FRAME"});
  EXPECT_EQ(obstacles(bus_with("task-manager", "TASK_STATE"), wish_for("task-manager")).size(), 1U);
}

TEST(Room, IsBesideWhoWritesOtherThings) {
  EXPECT_EQ(obstacles(bus_with("simulator", "JOINT_STATE"), wish_for("visual-servo")), Lines{});
  EXPECT_EQ(obstacles(bus_with("anybody", "UNLISTED"), wish_for("simulator")), Lines{});
}

TEST(Room, IsWhereManyMayWrite) {
  EXPECT_EQ(obstacles(bus_with("arm-driver", "STOP_STATE"), wish_for("simulator")), Lines{});
  EXPECT_EQ(obstacles(bus_with("task-operator", "STOP"), wish_for("task-operator")), Lines{});
}

TEST(Room, IsBesideAnyNumberOfBridgesAndWatchers) {
  EXPECT_EQ(obstacles(bus_with("bus-bridge", ""), wish_for("bus-bridge")), Lines{});
  EXPECT_EQ(obstacles(bus_with("mark-watcher", ""), wish_for("mark-watcher")), Lines{});
}

TEST(Room, IsNeededByWhoWritesWhatOneAloneMayWrite) {
  EXPECT_TRUE(needs_room({"mark-watcher", "simulator"}));
  EXPECT_FALSE(needs_room({"mark-watcher", "bus-bridge", "task-operator", "none"}));
}

TEST(Room, IsInThePlaceOfOnesOwnProcesses) {
  RoomWish wish = wish_for("simulator");
  wish.own = {kPid};
  EXPECT_EQ(obstacles(bus_with("simulator", "JOINT_STATE"), wish), Lines{});
  wish.host = "there";  // the same number on another host is another process
  EXPECT_EQ(obstacles(bus_with("simulator", "JOINT_STATE"), wish).size(), 1U);
}

TEST(Room, IsBesideAnotherRobotUnlessAnyCounts) {
  RoomWish wish = wish_for("simulator");
  EXPECT_EQ(obstacles(bus_with("simulator", "JOINT_STATE", "r2"), wish), Lines{});
  wish.robot = "r2";
  EXPECT_EQ(obstacles(bus_with("simulator", "JOINT_STATE", "r2"), wish).size(), 1U);
  wish.robot = std::nullopt;
  EXPECT_EQ(obstacles(bus_with("simulator", "JOINT_STATE", "r2"), wish).size(), 1U);
}

TEST(Room, IsRefusedInPrintableWords) {
  EXPECT_EQ(obstacles(bus_with("simulator\x1b[2J", "JOINT_STATE"), wish_for("simulator")),
            Lines{"simulator?[2J (process 41 on here) writes JOINT_STATE"});
}

}  // namespace
}  // namespace markservo::bus_census
