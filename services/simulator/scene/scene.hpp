#pragma once

// The world around the robot as a scene file (config/scenes/) describes it. SI units, positions in the scene frame S:
// the camera frame C of the robot at the scene's dock.

#include <Eigen/Core>
#include <string>
#include <vector>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/robot_description.hpp"

namespace markservo::simulator {

using Rgb = Eigen::Vector3d;  // each 0..1

struct ShelfScene {
  double top_z = 0.0;            // m
  double thickness = 0.0;        // m
  double width = 0.0;            // m
  double depth = 0.0;            // m
  double front_overhang = 0.0;   // m, the board's front edge before the spines
  double cabinet_setback = 0.0;  // m, the closed front below the board behind the board's edge
};

struct BookScene {
  std::string mark;  // name in robot.yaml
  int place = 0;     // in spacings from the middle book, to the right
  Rgb cover = Rgb::Zero();
};

struct BooksScene {
  Eigen::Vector3d size = Eigen::Vector3d::Zero();  // m: thickness, depth, height
  double mass = 0.0;                               // kg
  double spacing = 0.0;                            // m
  double mark_z = 0.0;                             // m, centre of the marks
  std::vector<BookScene> row;
};

struct PrintScene {
  double grain = 0.0;  // standard deviation of the smoothing, in edges of the mark
  Eigen::Vector2d value = Eigen::Vector2d::Zero();
  Eigen::Vector2d saturation = Eigen::Vector2d::Zero();
  double hue_share = 0.0;  // part of the mark's hue interval in use
};

struct SideTableScene {
  Eigen::Vector2d x = Eigen::Vector2d::Zero();  // m, from, to
  Eigen::Vector2d y = Eigen::Vector2d::Zero();  // m, from, to
  double top_z = 0.0;                           // m
  double leg_width = 0.0;                       // m, of the closed leg below the table's left edge
};

// Where the robot stands for the scene's positions to be what its cameras see.
struct DockScene {
  std::string field;         // of floor tags, in robot.yaml
  double x = 0.0;            // m in W, the field's frame
  double y = 0.0;            // m
  double heading_deg = 0.0;  // deg

  geometry::PlanePose X_WD() const { return geometry::pose_from_degrees(x, y, heading_deg); }
};

struct RoomScene {
  double floor_z = 0.0;  // m
  double wall_y = 0.0;   // m
  Rgb wall = Rgb::Zero();
  Rgb floor = Rgb::Zero();
};

struct Lamp {
  Eigen::Vector3d direction = Eigen::Vector3d::Zero();  // the light goes to, any length above 0
  double brightness = 0.0;
};

struct LightScene {
  double ambient = 0.0;
  std::vector<Lamp> lamps;
};

struct Distractor {
  bool sphere = false;                               // else a box
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();  // m
  Eigen::Vector3d size = Eigen::Vector3d::Zero();    // m, edges; a sphere's diameter first
  Rgb colour = Rgb::Zero();
};

struct Scene {
  DockScene dock;  // all zero for a robot without a base
  ShelfScene shelf;
  BooksScene books;
  PrintScene print;
  SideTableScene side_table;
  RoomScene room;
  LightScene light;
  std::vector<Distractor> distractors;
};

// Reads and checks a scene file; every book's mark must be a target of `robot`, and the dock in one of its tag
// fields. Throws ConfigurationError: one line with file, key, value and what is allowed.
Scene load_scene(const std::string& path, const robot::RobotDescription& robot);

}  // namespace markservo::simulator
