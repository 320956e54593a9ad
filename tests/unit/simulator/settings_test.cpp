#include "services/simulator/settings/settings.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <vector>

#include "common/robot/configuration_error.hpp"
#include "services/simulator/model/scene_model.hpp"
#include "services/simulator/scene/scene.hpp"

namespace markservo::simulator {
namespace {

const std::string kRoot = MARKSERVO_SOURCE_DIR;

robot::RobotDescription default_robot() {
  return robot::load_robot_description(kRoot + "/config/robot.yaml");
}

Scene default_scene() {
  return load_scene(kRoot + "/config/scenes/shelf.yaml", default_robot());
}

std::string message_of(const std::function<void()>& action) {
  try {
    action();
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "";
}

// The shelf scene with one text replaced by another.
std::string changed_scene(const std::string& from, const std::string& to) {
  std::ifstream file(kRoot + "/config/scenes/shelf.yaml");
  std::stringstream content;
  content << file.rdbuf();
  std::string text = content.str();
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  text.replace(at, from.size(), to);
  std::string path = testing::TempDir() + "simulator_scene.yaml";
  std::ofstream(path) << text;
  return path;
}

TEST(Settings, DefaultsComeFromTheRobot) {
  const Settings settings = default_settings(default_robot(), default_scene(), true);
  EXPECT_NEAR(settings.arm.start_shoulder_deg, 120.0, 1e-9);
  EXPECT_EQ(settings.arm.start_opening, 0.05);
  EXPECT_EQ(settings.frames.rate_hz, 30.0);
  EXPECT_EQ(default_settings(default_robot(), default_scene(), false).frames.rate_hz, 15.0);
}

TEST(Settings, EveryDefaultIsAllowed) {
  const Settings defaults = default_settings(default_robot(), default_scene(), true);
  for (const auto& setting : setting_descriptions()) {
    Settings settings = defaults;
    EXPECT_NO_THROW(set_value(settings, setting.name, setting.value(defaults))) << setting.name;
  }
}

TEST(Settings, EveryNameIsTakenOnceAndSetsANumberOfItsOwn) {
  for (const auto& setting : setting_descriptions()) {
    Settings settings;
    setting.set(settings, 0.125);
    for (const auto& other : setting_descriptions()) {
      if (&other == &setting) continue;
      EXPECT_NE(other.name, setting.name);
      EXPECT_EQ(other.value(settings), other.value(Settings())) << other.name << " changed with " << setting.name;
    }
    EXPECT_EQ(setting.value(settings), 0.125) << setting.name;
  }
}

TEST(Settings, OnesOfAPartStandTogetherInTheList) {
  std::vector<std::string> parts;
  for (const auto& setting : setting_descriptions()) {
    const std::string part = setting.name.substr(0, setting.name.find('.'));
    if (parts.empty() || parts.back() != part) parts.push_back(part);
  }
  EXPECT_EQ(parts, (std::vector<std::string>{"books", "marks", "image", "light", "servo", "calibration", "arm",
                                             "gripper", "base", "rfid", "sonar", "obstacle", "frames", "faults"}));
}

TEST(Settings, AreSetByName) {
  Settings settings;
  set_from_text(settings, "books.slant_deg=-20");
  EXPECT_EQ(settings.books.slant_deg, -20.0);
}

TEST(Settings, UnknownNamesAreErrorsThatListTheKnown) {
  Settings settings;
  const std::string message = message_of([&] { set_from_text(settings, "book.x=1"); });
  EXPECT_NE(message.find("'book.x' is unknown"), std::string::npos);
  EXPECT_NE(message.find("books.x"), std::string::npos);
}

TEST(Settings, ImpossibleValuesAreErrorsThatNameTheRange) {
  Settings settings;
  EXPECT_NE(message_of([&] { set_from_text(settings, "image.noise_sigma=-1"); }).find("from 0 to 50"),
            std::string::npos);
  for (const char* text : {"image.noise_sigma=", "image.noise_sigma=x", "image.noise_sigma=1x", "image.noise_sigma=nan",
                           "image.noise_sigma", "servo.deadband_kind=0.5", "servo.delay_frames=1.5"}) {
    EXPECT_NE(message_of([&] { set_from_text(settings, text); }), "") << text;
  }
}

TEST(Settings, TheStartPostureStaysInsideTheArmsLimits) {
  Settings settings = default_settings(default_robot(), default_scene(), true);
  settings.arm.start_elbow_deg = 10.0;
  EXPECT_NE(message_of([&] { check_against_robot(settings, default_robot()); }).find("arm.start_elbow_deg"),
            std::string::npos);
}

TEST(Scene, TheShelfHasTheThreeBooks) {
  const Scene scene = load_scene(kRoot + "/config/scenes/shelf.yaml", default_robot());
  ASSERT_EQ(scene.books.row.size(), 3U);
  EXPECT_EQ(scene.books.row[0].mark, "red_book");
  EXPECT_EQ(scene.books.row[0].place, 0);
  EXPECT_EQ(scene.books.row[1].place, 1);
  EXPECT_EQ(scene.books.row[2].place, -1);
}

TEST(Scene, MistakesAreNamedWithFileAndKey) {
  const auto message = [](const std::string& from, const std::string& to) {
    return message_of([&] { load_scene(changed_scene(from, to), default_robot()); });
  };
  EXPECT_NE(message("mass: 0.3", "mass: -0.3").find("'books.mass' is -0.3"), std::string::npos);
  EXPECT_NE(message("mass: 0.3", "weight: 0.3").find("'books.mass' is missing"), std::string::npos);
  EXPECT_NE(message("mark: red_book", "mark: hand").find("role target"), std::string::npos);
  EXPECT_NE(message("mark: red_book", "mark: blue_book").find("one book only"), std::string::npos);
  EXPECT_NE(message("shape: sphere", "shape: cone").find("box or sphere"), std::string::npos);
  EXPECT_NE(message("room:", "rooms:").find("'room' is missing"), std::string::npos);
}

TEST(Scene, OnlyCamerasThatCanBeDrawnAreAccepted) {
  robot::RobotDescription robot = default_robot();
  const Scene scene = load_scene(kRoot + "/config/scenes/shelf.yaml", robot);
  const Settings settings = default_settings(robot, scene, true);
  robot.cameras.stereo.cx_left += 1.0;
  EXPECT_NE(message_of([&] { write_scene_model(robot, scene, settings, 1); }).find("cx_left"), std::string::npos);
  robot = default_robot();
  robot.cameras.stereo.fy += 1.0;
  EXPECT_NE(message_of([&] { write_scene_model(robot, scene, settings, 1); }).find("fy_px"), std::string::npos);
}

}  // namespace
}  // namespace markservo::simulator
