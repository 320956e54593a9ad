#include "services/simulator/model/physics.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <atomic>
#include <cstring>
#include <stdexcept>
#include <string>

#include "common/robot/configuration_error.hpp"
#include "services/simulator/model/scene_model.hpp"

namespace markservo::simulator {
namespace {

std::uint64_t next_id() {
  static std::atomic<std::uint64_t> last{0};
  return ++last;
}

mjModel* compile(const SceneModel& scene_model) {
  // mjVFS is 200 KB of names: not for the stack.
  const auto vfs = std::make_unique<mjVFS>();
  mj_defaultVFS(vfs.get());
  const char* const kFile = "world.xml";
  const auto size = static_cast<int>(scene_model.mjcf.size());
  if (mj_makeEmptyFileVFS(vfs.get(), kFile, size) != 0)
    throw std::runtime_error("MuJoCo's virtual file system is full");
  const int index = mj_findFileVFS(vfs.get(), kFile);
  std::memcpy(vfs->filedata[index], scene_model.mjcf.data(), scene_model.mjcf.size());
  char error[1000] = "";
  mjModel* model = mj_loadXML(kFile, vfs.get(), error, sizeof error);
  mj_deleteVFS(vfs.get());
  if (model == nullptr) throw ConfigurationError(std::string("MuJoCo refuses the world: ") + error);
  return model;
}

void paint(mjModel* model, const SceneModel& scene_model) {
  for (const auto& [name, texture] : scene_model.textures) {
    const int id = mj_name2id(model, mjOBJ_TEXTURE, name.c_str());
    if (id < 0 || model->tex_width[id] != texture.edge || model->tex_height[id] != texture.edge) {
      throw std::logic_error("texture '" + name + "' is not in the model as written");
    }
    std::copy(texture.rgb.begin(), texture.rgb.end(), model->tex_rgb + model->tex_adr[id]);
  }
}

}  // namespace

void Physics::ModelDeleter::operator()(mjModel_* model) const {
  mj_deleteModel(model);
}

void Physics::DataDeleter::operator()(mjData_* data) const {
  mj_deleteData(data);
}

Physics::Physics(const SceneModel& scene_model) : id_(next_id()) {
  // MuJoCo would write a log file into the working folder; require_stable() looks at the warnings' counters instead.
  mju_user_warning = [](const char*) {};
  model_.reset(compile(scene_model));
  paint(model_.get(), scene_model);
  data_.reset(mj_makeData(model_.get()));
}

void Physics::require_stable() const {
  // MuJoCo answers divergence by putting its own state back to the start, silently: that must never pass as physics.
  for (const int warning : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
    if (data_->warning[warning].number > 0) throw std::runtime_error("the simulated physics diverged");
  }
}

}  // namespace markservo::simulator
