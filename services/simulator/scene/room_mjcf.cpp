#include "services/simulator/scene/room_mjcf.hpp"

#include "services/simulator/contacts/contact_classes.hpp"
#include "services/simulator/model/mjcf_writer.hpp"

namespace markservo::simulator {
namespace {

using Eigen::Vector3d;

constexpr double kPi = 3.141592653589793;

// A box between two corners.
std::string box_between(const std::string& name, const Vector3d& from, const Vector3d& to) {
  return "<geom " + named(name) + " " + at(0.5 * (from + to)) + " " + box(to - from);
}

std::string shelf_geoms(const Scene& scene, const BooksSettings& settings, const std::string& surface) {
  const ShelfScene& shelf = scene.shelf;
  const double front = settings.y - shelf.front_overhang;
  const double board_bottom = shelf.top_z - shelf.thickness;
  const double left = settings.x - 0.5 * shelf.width;
  const double right = settings.x + 0.5 * shelf.width;
  return box_between("shelf", {left, front, board_bottom}, {right, front + shelf.depth, shelf.top_z}) +
         " material=\"wood\"" + surface + "/>\n" +
         box_between("cabinet", {left, front + shelf.cabinet_setback, scene.room.floor_z},
                     {right, front + shelf.depth, board_bottom}) +
         " material=\"wood\"" + surface + "/>\n";
}

std::string side_table_geoms(const Scene& scene, const std::string& surface) {
  constexpr double kThickness = 0.018;  // m
  const SideTableScene& table = scene.side_table;
  const double board_bottom = table.top_z - kThickness;
  return box_between("side_table", {table.x[0], table.y[0], board_bottom}, {table.x[1], table.y[1], table.top_z}) +
         " material=\"wood\"" + surface + "/>\n" +
         box_between("side_table_leg", {table.x[0], table.y[0], scene.room.floor_z},
                     {table.x[0] + table.leg_width, table.y[1], board_bottom}) +
         " material=\"wood\"" + surface + "/>\n";
}

}  // namespace

std::string room_geoms(const Scene& scene) {
  constexpr double kWallLength = 2.4;  // m
  constexpr double kFloorSize = 6.0;   // m: a robot may start far before the shelf
  const RoomScene& room = scene.room;
  constexpr double kWallHeight = 1.8;  // m
  Eigen::Isometry3d wall = Eigen::Isometry3d::Identity();
  wall.translation() << 0.0, room.wall_y + 0.02, room.floor_z + 0.5 * kWallHeight;
  wall.rotate(Eigen::AngleAxisd(0.5 * kPi, Vector3d::UnitX()));
  std::string out =
      "<geom name=\"wall\" " + placed(wall) + " " + box({kWallLength, kWallHeight, 0.04}) + " material=\"wall\"/>\n";
  out += "<geom name=\"floor\" " + at({0.0, room.wall_y - 0.5 * kFloorSize, room.floor_z - 0.02}) + " " +
         box({kFloorSize, kFloorSize, 0.04}) + " material=\"floor\"/>\n";
  int number = 0;
  for (const Distractor& thing : scene.distractors) {
    const std::string shape =
        thing.sphere ? "type=\"sphere\" size=\"" + mjcf(0.5 * thing.size[0]) + "\"" : box(thing.size);
    out += "<geom " + named("distractor_" + std::to_string(++number)) + " " + at(thing.centre) + " " + shape + " " +
           coloured(thing.colour) + " material=\"matt\" " + kNoContact + "/>\n";
  }
  return out;
}

std::string furniture_geoms(const Scene& scene, const BooksSettings& settings) {
  const std::string surface = " friction=\"" + mjcf(settings.friction) + " 0.005 0.0001\" " + kStiff;
  return shelf_geoms(scene, settings, surface) + side_table_geoms(scene, surface);
}

}  // namespace markservo::simulator
