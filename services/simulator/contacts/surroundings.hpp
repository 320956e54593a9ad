#pragma once

// What stands around the robot in the MuJoCo model, as its sonars and its outline meet it.

#include <optional>
#include <vector>

#include "services/simulator/contacts/footprint.hpp"
#include "services/simulator/readers/sonar_model.hpp"

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

// m, how far each ray goes from its origin until it meets something that is not the robot; nothing if it never does.
// `rays` in S; `data` with poses up to date.
std::vector<std::optional<double>> cast_rays(const mjModel_* model, const mjData_* data, const std::vector<Ray>& rays);

// The upright boxes of the room that reach into heights `z_from` to `z_to` (m in S), the one that the obstacle is
// included wherever it stands: what can stop a base. Geoms of the model.
std::vector<int> standing_boxes(const mjModel_* model, const mjData_* data, double z_from, double z_to);

// The floor that an upright box stands on, in S.
Footprint footprint_of(const mjModel_* model, const mjData_* data, int geom);

}  // namespace markservo::simulator
