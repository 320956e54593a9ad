#include "services/simulator/contacts/box_contacts.hpp"

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <string>

namespace markservo::simulator {
namespace {

// A book on a shelf as MuJoCo sees it.
const std::string kBookOnShelf =
    "<mujoco><worldbody><geom type='box' size='0.18 0.075 0.009' pos='0 0 -0.009'/>"
    "<body pos='0 0 0.1'><freejoint/><geom type='box' size='0.0125 0.06 0.1' mass='0.3'/></body></worldbody></mujoco>";

struct Depths {
  int contacts = 0;
  double deepest = 0.0;  // m
};

// The book's centre at (x, y, z), turned by `yaw`, tilted by `a` and `b` about its own x and y.
Depths contacts_at(double x, double y, double z, double yaw, double a, double b) {
  const auto vfs = std::make_unique<mjVFS>();
  mj_defaultVFS(vfs.get());
  mj_makeEmptyFileVFS(vfs.get(), "book.xml", static_cast<int>(kBookOnShelf.size()));
  std::memcpy(vfs->filedata[0], kBookOnShelf.data(), kBookOnShelf.size());
  char error[500] = "";
  mjModel* model = mj_loadXML("book.xml", vfs.get(), error, sizeof error);
  mj_deleteVFS(vfs.get());
  mjData* data = mj_makeData(model);
  const mjtNum turn[4] = {std::cos(yaw / 2), 0, 0, std::sin(yaw / 2)};
  mjtNum tilt[4] = {1, a / 2, b / 2, 0};
  mju_normalize4(tilt);
  data->qpos[0] = x;
  data->qpos[1] = y;
  data->qpos[2] = z;
  mju_mulQuat(data->qpos + 3, tilt, turn);
  mj_kinematics(model, data);
  mj_collision(model, data);
  Depths depths;
  depths.contacts = data->ncon;
  for (int i = 0; i < data->ncon; ++i) depths.deepest = std::max(depths.deepest, -data->contact[i].dist);
  mj_deleteData(data);
  mj_deleteModel(model);
  return depths;
}

// A posture for which MuJoCo 2.2.2 by itself reports eight contacts, one of them 167 mm deep.
TEST(BoxContacts, AContactOutsideTheBoxesIsDropped) {
  drop_impossible_box_contacts();
  const Depths depths = contacts_at(-0.015561354930084821, -0.0026460144174182752, 0.099991519186892266,
                                    0.37146122664425729, -1.2562712051755258e-14, 3.0938376107632101e-14);
  EXPECT_GE(depths.contacts, 4);
  EXPECT_LT(depths.deepest, 2e-5);
}

TEST(BoxContacts, TrueContactsStay) {
  drop_impossible_box_contacts();
  drop_impossible_box_contacts();  // once is enough, twice does no harm
  const Depths depths = contacts_at(0.01, 0.0, 0.1 - 1e-5, 0.3, 0.0, 0.0);
  EXPECT_GE(depths.contacts, 4);
  EXPECT_GT(depths.deepest, 4e-6);  // MuJoCo halves the depth between faces
  EXPECT_LT(depths.deepest, 1.1e-5);
  EXPECT_GE(contacts_at(0.01, 0.0, 0.1 - 0.005, 0.3, 0.01, 0.0).contacts, 2) << "deep ones of an impact too";
}

}  // namespace
}  // namespace markservo::simulator
