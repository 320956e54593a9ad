#include "services/simulator/scene/scene.hpp"

#include <set>

#include "common/robot/yaml_section.hpp"

namespace markservo::simulator {
namespace {

using robot::Allowed;
using robot::YamlSection;

const Allowed kShare = Allowed::between(0.0, 1.0);

ShelfScene read_shelf(YamlSection section) {
  ShelfScene shelf;
  shelf.top_z = section.number("top_z", Allowed::any());
  shelf.thickness = section.number("thickness", Allowed::positive());
  shelf.width = section.number("width", Allowed::positive());
  shelf.depth = section.number("depth", Allowed::positive());
  shelf.front_overhang = section.number("front_overhang", Allowed::between(0.0, 0.1));
  shelf.cabinet_setback = section.number("cabinet_setback", Allowed::between(0.0, 1.0));
  if (shelf.cabinet_setback >= shelf.depth) {
    section.fail("cabinet_setback", std::to_string(shelf.cabinet_setback), "less than the shelf's depth");
  }
  section.require_all_used();
  return shelf;
}

BookScene read_book(YamlSection section, const robot::RobotDescription& robot, std::set<std::string>& taken) {
  BookScene book;
  book.mark = section.text("mark");
  const robot::MarkDescription* mark = robot.find_mark(book.mark);
  if (mark == nullptr || mark->role != robot::MarkRole::kTarget) {
    section.fail("mark", "'" + book.mark + "'", "a mark of role target in robot.yaml");
  }
  if (!taken.insert(book.mark).second) section.fail("mark", "'" + book.mark + "'", "each mark on one book only");
  book.place = section.integer("place", -10, 10);
  if (!taken.insert("place " + std::to_string(book.place)).second) {
    section.fail("place", std::to_string(book.place), "one book in each place");
  }
  book.cover = section.numbers("cover_rgb", 3, kShare);
  section.require_all_used();
  return book;
}

BooksScene read_books(YamlSection section, const robot::RobotDescription& robot) {
  BooksScene books;
  books.size = section.numbers("size", 3, Allowed::positive());
  books.mass = section.number("mass", Allowed::positive());
  books.spacing = section.number("spacing", Allowed::positive());
  books.mark_z = section.number("mark_z", Allowed::any());
  std::set<std::string> taken;
  for (auto& item : section.list("row")) books.row.push_back(read_book(item, robot, taken));
  if (books.row.empty()) section.fail("row", "empty", "at least one book");
  section.require_all_used();
  return books;
}

PrintScene read_print(YamlSection section) {
  PrintScene print;
  print.grain = section.number("grain", Allowed::between(0.005, 0.5));
  print.value = section.numbers("value", 2, kShare);
  print.saturation = section.numbers("saturation", 2, kShare);
  print.hue_share = section.number("hue_share", kShare);
  section.require_all_used();
  return print;
}

SideTableScene read_side_table(YamlSection section) {
  SideTableScene table;
  table.x = section.numbers("x", 2, Allowed::any());
  table.y = section.numbers("y", 2, Allowed::any());
  table.top_z = section.number("top_z", Allowed::any());
  table.leg_width = section.number("leg_width", Allowed::between(0.001, 1.0));
  if (table.x[0] >= table.x[1]) section.fail("x", "not rising", "from, to with from below to");
  if (table.y[0] >= table.y[1]) section.fail("y", "not rising", "from, to with from below to");
  section.require_all_used();
  return table;
}

DockScene read_dock(YamlSection section, const robot::RobotDescription& robot) {
  DockScene dock;
  dock.field = section.text("field");
  if (robot.floor_tags) robot.floor_tags->field(dock.field);  // throws if there is none
  const Eigen::Vector3d pose = section.numbers("pose", 3, Allowed::between(-1000.0, 1000.0));
  dock.x = pose[0];
  dock.y = pose[1];
  dock.heading_deg = pose[2];
  section.require_all_used();
  return dock;
}

RoomScene read_room(YamlSection section) {
  RoomScene room;
  room.floor_z = section.number("floor_z", Allowed::between(-5.0, -0.5));
  room.wall_y = section.number("wall_y", Allowed::between(0.5, 10.0));
  room.wall = section.numbers("wall_rgb", 3, kShare);
  room.floor = section.numbers("floor_rgb", 3, kShare);
  section.require_all_used();
  return room;
}

LightScene read_light(YamlSection section) {
  LightScene light;
  light.ambient = section.number("ambient", kShare);
  for (auto& item : section.list("lamps")) {
    Lamp lamp;
    lamp.direction = item.numbers("direction", 3, Allowed::between(-1e3, 1e3));
    lamp.brightness = item.number("brightness", Allowed::between(0.0, 2.0));
    if (lamp.direction.norm() < 1e-6) item.fail("direction", "[0, 0, 0]", "a direction");
    item.require_all_used();
    light.lamps.push_back(lamp);
  }
  section.require_all_used();
  return light;
}

Distractor read_distractor(YamlSection section) {
  Distractor distractor;
  distractor.sphere = section.one_of("shape", {"box", "sphere"}) == "sphere";
  distractor.centre = section.numbers("centre", 3, Allowed::any());
  distractor.size = section.numbers("size", 3, Allowed::positive());
  distractor.colour = section.numbers("rgb", 3, kShare);
  section.require_all_used();
  return distractor;
}

}  // namespace

Scene load_scene(const std::string& path, const robot::RobotDescription& robot) {
  YamlSection file = YamlSection::load(path);
  Scene scene;
  if (robot.base || file.has("dock")) scene.dock = read_dock(file.section("dock"), robot);
  scene.shelf = read_shelf(file.section("shelf"));
  scene.books = read_books(file.section("books"), robot);
  scene.print = read_print(file.section("print"));
  scene.side_table = read_side_table(file.section("side_table"));
  scene.room = read_room(file.section("room"));
  scene.light = read_light(file.section("light"));
  for (auto& item : file.list("distractors")) scene.distractors.push_back(read_distractor(item));
  file.require_all_used();
  return scene;
}

}  // namespace markservo::simulator
