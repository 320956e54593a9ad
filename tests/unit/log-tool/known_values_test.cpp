// What a message says is not known is in no table.

#include "services/log-tool/known_values.hpp"

#include <gtest/gtest.h>

#include <map>
#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/JointState.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/TargetPose.hpp>
#include <markservo/TaskCommand.hpp>
#include <string>
#include <vector>

#include "common/reflection/value_text.hpp"
#include "tests/unit/encoded.hpp"

namespace markservo::log_tool {
namespace {

// The known values as text, by their paths.
template <class M>
std::map<std::string, std::string> known(const M& message) {
  const auto bytes = test::encoded(message);
  auto decoded = reflection::decode(reflection::TypeCatalog::ours(), bytes.data(), bytes.size());
  EXPECT_EQ(decoded.error, "");
  leave_out_unknown(decoded.fields);
  std::map<std::string, std::string> texts;
  for (const auto& leaf : reflection::leaves(decoded.fields)) texts[leaf.path] = reflection::text_of(leaf.value);
  return texts;
}

template <class M>
void expect_known_only_then(M unknown, M then, const std::vector<std::string>& paths) {
  const auto before = known(unknown);
  const auto after = known(then);
  for (const std::string& path : paths) {
    EXPECT_EQ(before.count(path), 0U) << path;
    EXPECT_EQ(after.count(path), 1U) << path;
  }
  EXPECT_EQ(after.size() - before.size(), paths.size()) << "and nothing else is left out";
}

TEST(KnownValues, HaveNoPositionOfAMarkThatIsNotLocated) {
  TargetPose unseen{};
  unseen.num_marks = 2;
  unseen.marks.resize(2);
  unseen.marks[1].status = LocatedMark::UNSEEN;
  TargetPose located = unseen;
  located.marks[1].status = LocatedMark::LOCATED;
  located.marks[1].normal_C.y = -1.0;
  expect_known_only_then(
      unseen, located,
      {"marks[1].p_C.x", "marks[1].p_C.y", "marks[1].p_C.z", "marks[1].covariance.xx", "marks[1].covariance.xy",
       "marks[1].covariance.xz", "marks[1].covariance.yy", "marks[1].covariance.yz", "marks[1].covariance.zz",
       "marks[1].normal_C.x", "marks[1].normal_C.y", "marks[1].normal_C.z"});
}

TEST(KnownValues, HaveNoPlaceOfAMarkInAnImageThatDoesNotShowIt) {
  MarkDetection unseen{};
  unseen.num_marks = 1;
  unseen.marks.resize(1);
  unseen.marks[0].right.seen = 1;
  MarkDetection seen = unseen;
  seen.marks[0].left.seen = 1;
  expect_known_only_then(
      unseen, seen,
      {"marks[0].left.x", "marks[0].left.y", "marks[0].left.width", "marks[0].left.height", "marks[0].left.area",
       "marks[0].left.u", "marks[0].left.v", "marks[0].left.m_uu", "marks[0].left.m_uv", "marks[0].left.m_vv"});
}

TEST(KnownValues, HaveWhatFlagsSayIsKnownOnly) {
  JointState without_sensor{};
  JointState with_sensor{};
  with_sensor.contact_known = 1;
  expect_known_only_then(without_sensor, with_sensor, {"contact"});

  RfidTagHits bare{};
  bare.num_hits = 1;
  bare.hits.resize(1);
  RfidTagHits rich = bare;
  rich.hits[0].rssi_known = rich.hits[0].read_time_known = 1;
  expect_known_only_then(bare, rich, {"hits[0].rssi", "hits[0].read_utime"});

  RobotPose nothing{};
  RobotPose measured{};
  measured.paper.measured_known = 1;
  RobotPose directed = measured;
  directed.paper.direction_known = 1;
  expect_known_only_then(nothing, measured,
                         {"paper.utime", "paper.measured_x", "paper.measured_y", "paper.delay", "paper.compensated_x",
                          "paper.compensated_y"});
  expect_known_only_then(measured, directed, {"paper.direction", "paper.speed"});

  TaskCommand stand{};
  TaskCommand drive{};
  drive.drive = 1;
  expect_known_only_then(stand, drive, {"drive_pose.x", "drive_pose.y", "drive_pose.heading"});
  TaskCommand expected{};
  expected.expected_known = 1;
  expect_known_only_then(stand, expected, {"p_CT_expected.x", "p_CT_expected.y", "p_CT_expected.z"});
}

TEST(KnownValues, HaveWhatAGoalOfAnotherKindDoesNotSay) {
  BaseGoal stand{};
  BaseGoal drive{};
  drive.kind = BaseGoal::DRIVE;
  expect_known_only_then(stand, drive, {"pose.x", "pose.y", "pose.heading"});
  ServoGoal hold{};
  ServoGoal servo{};
  servo.kind = ServoGoal::SERVO;
  expect_known_only_then(hold, servo, {"p_TG_C.x", "p_TG_C.y", "p_TG_C.z", "tolerance"});
}

TEST(KnownValues, HaveNoZeroThatStandsForNothingMeasured) {
  BaseStatus nowhere{};
  BaseStatus at_the_pose{};
  at_the_pose.heading_error = 0.1;
  expect_known_only_then(nowhere, at_the_pose, {"distance", "heading_error"});

  ServoStatus blind{};
  ServoStatus there{};
  there.covariance.xx = 1e-6;
  expect_known_only_then(blind, there,
                         {"error_C.x", "error_C.y", "error_C.z", "covariance.xx", "covariance.xy", "covariance.xz",
                          "covariance.yy", "covariance.yz", "covariance.zz"});

  TargetPose free_surface{};
  free_surface.num_marks = 1;
  free_surface.marks.resize(1);
  TargetPose plane = free_surface;
  plane.marks[0].normal_C.y = -1.0;
  expect_known_only_then(free_surface, plane, {"marks[0].normal_C.x", "marks[0].normal_C.y", "marks[0].normal_C.z"});

  MarkDetection without_patch{};
  without_patch.num_marks = 1;
  without_patch.marks.resize(1);
  MarkDetection at_the_corner = without_patch;
  at_the_corner.marks[0].left.patch.width = 4;
  expect_known_only_then(
      without_patch, at_the_corner,
      {"marks[0].left.patch.x", "marks[0].left.patch.y", "marks[0].left.patch.width", "marks[0].left.patch.height"});
}

TEST(KnownValues, HaveNoAgeOfAChannelThatNobodyHeard) {
  ServiceStatus deaf{};
  deaf.num_channels = 1;
  deaf.channels.resize(1);
  deaf.channels[0].age = -1.0;
  ServiceStatus hearing = deaf;
  hearing.channels[0].age = 0.0;
  expect_known_only_then(deaf, hearing, {"channels[0].age", "channels[0].latency_p50", "channels[0].latency_p99"});
}

}  // namespace
}  // namespace markservo::log_tool
