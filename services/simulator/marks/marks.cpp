#include "services/simulator/marks/marks.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "services/simulator/marks/mark_mjcf.hpp"
#include "services/simulator/model/mujoco_arrays.hpp"

namespace markservo::simulator {

Marks::Marks(const mjModel_* model, const std::vector<robot::MarkDescription>& marks) {
  int number = 0;
  for (const robot::MarkDescription& mark : marks) {
    ++number;
    const int geom = mj_name2id(model, mjOBJ_GEOM, print_name(mark.name).c_str());
    if (geom >= 0) marks_.push_back({mark.name, number, geom, model->geom_matid[geom]});
  }
}

void Marks::cover(mjModel_* model, const MarkSettings& settings) const {
  constexpr int kNoMaterial = -1;  // then a geom has its own colour
  constexpr float kCard = 0.5F;
  constexpr std::ptrdiff_t kColour = 4;  // numbers, red, green, blue and alpha
  for (const Mark& mark : marks_) {
    const bool covered = static_cast<double>(mark.number) == settings.covered;
    model->geom_matid[mark.geom] = covered ? kNoMaterial : mark.material;
    if (covered) std::fill_n(model->geom_rgba + kColour * mark.geom, 3, kCard);
  }
}

std::vector<MarkTruth> Marks::truth(const mjData_* data, const Eigen::Isometry3d& X_CS) const {
  std::vector<MarkTruth> truths;
  for (const Mark& mark : marks_) {
    MarkTruth truth;
    truth.name = mark.name;
    truth.normal_C = X_CS.linear() * matrix(data->geom_xmat + kMatrix * mark.geom).col(2);
    truth.p_CM = X_CS * vector(data->geom_xpos + kVector * mark.geom) + 0.5 * kPrintThickness * truth.normal_C;
    truths.push_back(std::move(truth));
  }
  return truths;
}

}  // namespace markservo::simulator
