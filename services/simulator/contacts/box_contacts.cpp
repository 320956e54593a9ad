#include "services/simulator/contacts/box_contacts.hpp"

#include <algorithm>
#include <cmath>
#include <mutex>

#include "services/simulator/model/mujoco_arrays.hpp"

namespace markservo::simulator {
namespace {

// A contact lies midway between the two surfaces, so within half its depth of each; depths are far below this.
constexpr double kTolerance = 0.01;  // m

mjfCollision box_box = nullptr;

bool inside(const mjModel* model, const mjData* data, int geom, const mjtNum* point) {
  const mjtNum* centre = data->geom_xpos + kVector * geom;
  const mjtNum* axes = data->geom_xmat + kMatrix * geom;  // row by row: column k is the box's axis k
  const mjtNum* half = model->geom_size + kVector * geom;
  for (int k = 0; k < 3; ++k) {
    double along = 0.0;
    for (int i = 0; i < 3; ++i) along += axes[3 * i + k] * (point[i] - centre[i]);
    if (std::abs(along) > half[k] + kTolerance) return false;
  }
  return true;
}

int checked_box_box(const mjModel* model, const mjData* data, mjContact* contacts, int geom1, int geom2,
                    mjtNum margin) {
  const int count = box_box(model, data, contacts, geom1, geom2, margin);
  mjContact* const end = std::remove_if(contacts, contacts + count, [&](const mjContact& contact) {
    return !inside(model, data, geom1, contact.pos) || !inside(model, data, geom2, contact.pos);
  });
  return static_cast<int>(end - contacts);
}

}  // namespace

void drop_impossible_box_contacts() {
  static std::once_flag once;
  std::call_once(once, [] {
    box_box = mjCOLLISIONFUNC[mjGEOM_BOX][mjGEOM_BOX];
    mjCOLLISIONFUNC[mjGEOM_BOX][mjGEOM_BOX] = checked_box_box;
  });
}

}  // namespace markservo::simulator
