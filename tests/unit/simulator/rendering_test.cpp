#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/geometry/stereo_camera.hpp"
#include "services/simulator/cameras/stereo_renderer.hpp"
#include "tests/unit/simulator/test_world.hpp"

namespace markservo::simulator {
namespace {

StereoRenderer& renderer() {
  static StereoRenderer the_renderer;
  return the_renderer;
}

// The scene with marks of one plain colour, so that a pixel's colour tells how much of it the mark fills.
Scene plain_scene() {
  Scene scene = test_scene();
  scene.print.value = {0.9, 0.9};
  scene.print.saturation = {0.9, 0.9};
  scene.print.hue_share = 0.0;
  return scene;
}

cv::Vec3d colour_part(const cv::Vec3d& bgr) {
  return bgr - cv::Vec3d::all((bgr[0] + bgr[1] + bgr[2]) / 3.0);
}

// Centroid, px, of a plain mark before grey surroundings, `half` px around `guess`: each pixel weighs as much as it has
// of the colour in the middle. A square that faces the cameras has its centroid where its centre is.
cv::Point2d centroid(const cv::Mat& image, const cv::Point2d& guess, double half) {
  const cv::Point middle(static_cast<int>(std::lround(guess.x)), static_cast<int>(std::lround(guess.y)));
  const int reach = static_cast<int>(half) + 3;
  const cv::Vec3d colour = colour_part(image.at<cv::Vec3b>(middle));
  double sum = 0.0;
  cv::Point2d moment;
  for (int row = middle.y - reach; row <= middle.y + reach; ++row) {
    for (int column = middle.x - reach; column <= middle.x + reach; ++column) {
      const double share = colour_part(image.at<cv::Vec3b>(row, column)).dot(colour) / colour.dot(colour);
      if (share < 0.1) continue;  // greys are never quite grey
      sum += share;
      moment += share * cv::Point2d(column, row);
    }
  }
  return moment / sum;
}

struct Errors {
  double image_px = 0.0;  // largest in either image
  double depth_m = 0.0;   // largest
  double depth_sum_m = 0.0;
  int marks = 0;  // compared
};

Errors compare(World& world) {
  const robot::RobotDescription robot = test_robot();
  const auto& camera = robot.cameras.stereo;
  const WorldTruth truth = world.truth();
  const ImagePair images = renderer().render(world.physics());
  Errors errors;
  for (const auto& mark : truth.marks) {
    const auto expected = geometry::project(camera, mark.p_CM);
    if (!expected) continue;
    const double half_px = 0.5 * robot.find_mark(mark.name)->size * camera.fx / mark.p_CM.y();
    const double margin_px = half_px + 5.0;
    const auto inside = [&](double u) { return u > margin_px && u < robot.cameras.width - margin_px; };
    if (!inside(expected->u_left) || !inside(expected->u_right)) continue;
    if (std::abs(expected->v - camera.cy) > 0.5 * robot.cameras.height - margin_px) continue;
    const cv::Point2d left = centroid(images.left, {expected->u_left, expected->v}, half_px);
    const cv::Point2d right = centroid(images.right, {expected->u_right, expected->v}, half_px);
    ++errors.marks;
    errors.image_px = std::max({errors.image_px, std::abs(left.x - expected->u_left), std::abs(left.y - expected->v),
                                std::abs(right.x - expected->u_right), std::abs(right.y - expected->v)});
    const auto point = geometry::triangulate(camera, {left.x, 0.5 * (left.y + right.y), right.x});
    const double depth_error = std::abs(point->y() - mark.p_CM.y());
    errors.depth_m = std::max(errors.depth_m, depth_error);
    errors.depth_sum_m += depth_error;
  }
  return errors;
}

TEST(Rendering, MarksAreDrawnWhereTheTruthProjects) {
  double worst_px = 0.0;
  double worst_m = 0.0;
  double sum_m = 0.0;
  int marks = 0;
  for (const double y : {0.20, 0.25, 0.30, 0.35}) {
    for (const double x : {0.02, 0.0325, 0.0451}) {
      World world(test_robot(), plain_scene(), test_settings({{"books.x", x}, {"books.y", y}}), 1);
      const Errors errors = compare(world);
      worst_px = std::max(worst_px, errors.image_px);
      worst_m = std::max(worst_m, errors.depth_m);
      sum_m += errors.depth_sum_m;
      marks += errors.marks;
    }
  }
  std::printf("%d marks: image within %.3f px; depth off by %.3f mm on average, %.3f mm at most\n", marks, worst_px,
              sum_m / marks * 1000.0, worst_m * 1000.0);
  EXPECT_GE(marks, 20);
  EXPECT_LT(worst_px, 0.3);
  // Four samples a pixel leave up to an eighth of a pixel at a straight edge: 0.3 mm at 0.35 m, if both images have it.
  EXPECT_LT(sum_m / marks, 0.00015);
  EXPECT_LT(worst_m, 0.0004);
}

// How colourful the middle of a mark is in the left image: the distance of its pixel from grey, of 255.
double colourfulness(World& world, const std::string& name) {
  const auto& camera = test_robot().cameras.stereo;
  const cv::Mat image = renderer().render(world.physics()).left;
  for (const auto& mark : world.truth().marks) {
    if (mark.name != name) continue;
    const auto at = geometry::project(camera, mark.p_CM);
    return cv::norm(colour_part(image.at<cv::Vec3b>(cv::Point(static_cast<int>(at->u_left), static_cast<int>(at->v)))));
  }
  return 0.0;
}

TEST(Rendering, ACoveredMarkIsGreyUntilTheCardIsTakenAway) {
  constexpr double kRedBook = 2.0;  // its place in robot.yaml
  World world(test_robot(), plain_scene(), test_settings({}), 1);
  EXPECT_GT(colourfulness(world, "red_book"), 60.0);
  world.change(test_settings({{"marks.covered", kRedBook}}));
  EXPECT_LT(colourfulness(world, "red_book"), 15.0);
  EXPECT_GT(colourfulness(world, "blue_book"), 60.0);
  world.change(test_settings({}));
  EXPECT_GT(colourfulness(world, "red_book"), 60.0);
}

// How bright and how far apart a mark's pixels are, well inside it.
cv::Scalar deviation_within(World& world, const std::string& name) {
  const robot::RobotDescription robot = test_robot();
  const WorldTruth truth = world.truth();
  const ImagePair images = renderer().render(world.physics());
  for (const auto& mark : truth.marks) {
    if (mark.name != name) continue;
    const auto at = geometry::project(robot.cameras.stereo, mark.p_CM);
    const int half = static_cast<int>(0.3 * robot.find_mark(name)->size * robot.cameras.stereo.fx / mark.p_CM.y());
    const cv::Rect inside(static_cast<int>(at->u_left) - half, static_cast<int>(at->v) - half, 2 * half, 2 * half);
    cv::Scalar mean;
    cv::Scalar deviation;
    cv::meanStdDev(images.left(inside), mean, deviation);
    return deviation;
  }
  return cv::Scalar::all(NAN);
}

TEST(Rendering, MarksLookAsTheSettingSays) {
  const auto red_varies = [](double print) {
    World world(test_robot(), test_scene(), test_settings({{"marks.print", print}}), 1);
    return deviation_within(world, "red_book")[2];
  };
  const double printed = red_varies(0.0);
  EXPECT_GT(printed, 15.0);
  EXPECT_LT(red_varies(1.0), 0.25 * printed);  // plain: what the lamps make of it
  EXPECT_LT(red_varies(2.0), 0.5 * printed);   // faded
  EXPECT_GT(red_varies(2.0), red_varies(1.0));
  EXPECT_GT(red_varies(4.0), 15.0);  // a shadow across it
}

TEST(Rendering, TheHandsMarkIsDrawnWhereTheTruthProjects) {
  World world(test_robot(), plain_scene(), test_settings(), 1);
  const auto ik = robot::inverse_kinematics(*test_robot().arm, {0.0325, 0.245, -0.02}, 0.0);
  ASSERT_EQ(ik.status, robot::ReachStatus::kReachable);
  world.command(posture(ik.q, 0.05));
  wait(world, 2.0);
  const Errors errors = compare(world);
  std::printf("%d marks: image within %.3f px, depth within %.3f mm\n", errors.marks, errors.image_px,
              errors.depth_m * 1000.0);
  EXPECT_GE(errors.marks, 3);
  EXPECT_LT(errors.image_px, 0.3);
}

TEST(Rendering, FromElsewhereMarksAreDrawnWhereTheTruthProjects) {
  for (const double heading_deg : {90.0, 84.0}) {
    World world(test_robot(), plain_scene(),
                test_settings({{"base.start_y", 0.85}, {"base.start_heading_deg", heading_deg}}), 1);
    const Errors errors = compare(world);
    EXPECT_EQ(errors.marks, 3);
    EXPECT_LT(errors.image_px, 0.4) << "heading " << heading_deg << " degrees";
    EXPECT_LT(errors.depth_m, 0.002);
  }
}

TEST(Rendering, TheArmAtHomeIsOutOfView) {
  World near_shelf = test_world(test_settings());
  near_shelf.truth();
  const ImagePair home = renderer().render(near_shelf.physics());
  World turned = test_world(test_settings({{"arm.start_yaw_deg", 80.0}}));
  turned.truth();
  const ImagePair away = renderer().render(turned.physics());
  EXPECT_EQ(cv::norm(home.left, away.left, cv::NORM_INF), 0.0);
  EXPECT_EQ(cv::norm(home.right, away.right, cv::NORM_INF), 0.0);
}

TEST(Rendering, TheSameSeedGivesTheSamePicture) {
  const auto picture = [](std::uint64_t seed) {
    World world = test_world(test_settings(), seed);
    world.truth();
    return renderer().render(world.physics()).left;
  };
  EXPECT_EQ(cv::norm(picture(1), picture(1), cv::NORM_INF), 0.0);
  EXPECT_GT(cv::norm(picture(1), picture(2), cv::NORM_INF), 0.0) << "the light varies";
}

}  // namespace
}  // namespace markservo::simulator
