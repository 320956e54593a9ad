// A recorded drive and grasp that went well.

#include <gtest/gtest.h>

#include <set>
#include <string>

#include "common/logs/log_files.hpp"
#include "services/mmi/troubles/trouble_messages.hpp"

namespace markservo::mmi {
namespace {

constexpr double kStep = 0.1;  // s

TEST(AGoodRun, IsToldFromTheDriveToTheLiftWithoutATrouble) {
  const std::string path = std::string(MARKSERVO_SOURCE_DIR) + "/logs/reference/drive-and-grasp.lcm";
  const logs::LogFile log(path, logs::fit_of(reflection::TypeCatalog::ours()));
  TroubleWatch troubles({"arm", "base"});
  RobotState state;
  std::set<std::string> told;
  std::set<std::string> activities;
  double judged = 0.0;
  for (const logs::LogEvent& event : log.events()) {
    const double now = logs::seconds_apart(log.events().front().utime, event.utime);
    EXPECT_EQ(observe_message(std::string(event.channel), event.data.data, event.data.size, event.utime, now, troubles,
                              state),
              "");
    const std::string activity = state.activity();
    activities.insert(activity.substr(0, activity.find(':')));
    if (now - judged < kStep) continue;
    judged = now;
    for (const Trouble& trouble : troubles.step(now))
      told.insert(std::string(name_of(trouble.code)) + ": " + trouble.text);
  }
  EXPECT_EQ(told, std::set<std::string>{});
  for (const char* phase : {"DRIVE", "LOOK", "APPROACH", "SERVO", "GRIP", "LIFT", "VERIFY", "LIFT ON", "lifted"}) {
    EXPECT_EQ(activities.count(phase), 1U) << phase;
  }
}

}  // namespace
}  // namespace markservo::mmi
