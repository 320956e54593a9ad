#include "services/mmi/scene/scene_json.hpp"

#include <gtest/gtest.h>

#include "common/robot/configuration_error.hpp"

namespace markservo::mmi {
namespace {

using Json = nlohmann::ordered_json;

class SceneOfARobot : public ::testing::Test {
 protected:
  robot::RobotDescription robot_ = robot::load_robot_description(MARKSERVO_SOURCE_DIR "/config/robot.yaml");
};

TEST_F(SceneOfARobot, HasWhatStandsStill) {
  const Json scene = scene_json(robot_, "");
  EXPECT_EQ(scene["cameras"]["width_px"], 640);
  EXPECT_EQ(scene["cameras"]["cx_right_px"], 319.5);
  EXPECT_EQ(scene["cameras"]["p_RC"], Json({0.10, 0.0325, 0.70}));
  EXPECT_NEAR(scene["arm"]["foot_R"][0].get<double>(), 0.16, 1e-12);
  EXPECT_NEAR(scene["arm"]["column_top_R"][2].get<double>(), 0.40, 1e-12);
  EXPECT_NEAR(scene["arm"]["reach"].get<double>(), 0.40, 1e-12);
  EXPECT_EQ(scene["base"]["rear"], 0.18);
  EXPECT_EQ(scene["base"]["sonars"]["number"], 16);
  EXPECT_NEAR(scene["base"]["sonars"]["beam_width"].get<double>(), 0.5236, 1e-4);
  EXPECT_EQ(scene["rfid"]["p_RF"], Json({0.0, 0.0}));
  EXPECT_EQ(scene["rfid"]["reading_radius"], 0.10);
}

TEST_F(SceneOfARobot, HasTheMarks) {
  const Json marks = scene_json(robot_, "")["marks"];
  ASSERT_EQ(marks.size(), 4u);
  EXPECT_EQ(marks[0]["role"], "manipulator");
  EXPECT_TRUE(marks[0]["width"].is_null()) << "it is no object to be gripped";
  EXPECT_EQ(marks[1], Json({{"name", "red_book"},
                            {"role", "target"},
                            {"size", 0.025},
                            {"surface", "plane"},
                            {"outline", "square"},
                            {"colour", "#992626"},
                            {"width", 0.025}}));
}

TEST_F(SceneOfARobot, HasTheTagsOfTheFieldInUseOrOfAnotherByItsName) {
  const Json tags = scene_json(robot_, "")["tags"];
  ASSERT_EQ(tags.size(), 60u);
  EXPECT_EQ(tags[0], Json({{"uid", "E004015000001000"}, {"place", {0.0, 0.0}}}));
  EXPECT_EQ(scene_json(robot_, "hall")["tags"].size(), 1681u);
  EXPECT_THROW(scene_json(robot_, "nowhere"), ConfigurationError);
}

TEST_F(SceneOfARobot, SaysNullOfWhatTheRobotHasNot) {
  robot_.arm.reset();
  robot_.sonars.reset();
  robot_.rfid.reset();
  robot_.floor_tags.reset();
  const Json scene = scene_json(robot_, "");
  EXPECT_TRUE(scene["arm"].is_null());
  EXPECT_TRUE(scene["base"]["sonars"].is_null());
  EXPECT_TRUE(scene["rfid"].is_null());
  EXPECT_EQ(scene["tags"], Json::array());
  robot_.base.reset();
  EXPECT_TRUE(scene_json(robot_, "")["base"].is_null());
}

TEST(ColourOfAMark, IsTheMiddleOfItsInterval) {
  EXPECT_EQ(colour_text({0.0, 0.0, 1.0, 1.0, 1.0, 1.0}), "#ff0000");
  EXPECT_EQ(colour_text({350.0, 10.0, 1.0, 1.0, 1.0, 1.0}), "#ff0000") << "hue wraps";
  EXPECT_EQ(colour_text({340.0, 20.0, 1.0, 1.0, 0.0, 1.0}), "#800000");
  EXPECT_EQ(colour_text({110.0, 130.0, 1.0, 1.0, 1.0, 1.0}), "#00ff00");
  EXPECT_EQ(colour_text({200.0, 220.0, 1.0, 1.0, 1.0, 1.0}), "#0080ff");
  EXPECT_EQ(colour_text({50.0, 70.0, 0.0, 1.0, 1.0, 1.0}), "#ffff80");
  EXPECT_EQ(colour_text({280.0, 320.0, 1.0, 1.0, 1.0, 1.0}), "#ff00ff");
  EXPECT_EQ(colour_text({0.0, 40.0, 0.0, 0.0, 0.4, 0.6}), "#808080");
}

}  // namespace
}  // namespace markservo::mmi
