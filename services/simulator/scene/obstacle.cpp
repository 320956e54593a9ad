#include "services/simulator/scene/obstacle.hpp"

#include <cmath>

#include "services/simulator/model/mjcf_writer.hpp"
#include "services/simulator/model/mujoco_arrays.hpp"

namespace markservo::simulator {
namespace {

constexpr const char* kName = "obstacle";  // of body and box
constexpr double kHeight = 1.7;            // m, a person's

}  // namespace

std::string obstacle_body() {
  const std::string name = named(kName);
  return "<body " + name + " mocap=\"true\"><geom " + name + " " + box({0.3, 0.3, kHeight}) + " " +
         coloured({0.35, 0.42, 0.40}) + " material=\"matt\"/></body>\n";
}

Obstacle::Obstacle(const mjModel_* model, const SceneFrame& frame, double floor_z)
    : frame_(frame), floor_z_(floor_z), body_(mj_name2id(model, mjOBJ_BODY, kName)) {}

void Obstacle::put(mjModel_* model, mjData_* data, const ObstacleSettings& settings) const {
  constexpr double kOutOfTheWorld = -100.0;  // m, z
  const int geom = model->body_geomadr[body_];
  mjtNum* const half = model->geom_size + kVector * geom;
  half[0] = half[1] = 0.5 * settings.size;
  model->geom_rbound[geom] = vector(half).norm();
  const Eigen::Vector2d p_S = frame_.place({settings.x, settings.y});
  mjtNum* const position = data->mocap_pos + kVector * model->body_mocapid[body_];
  position[0] = p_S.x();
  position[1] = p_S.y();
  position[2] = settings.present != 0.0 ? floor_z_ + 0.5 * kHeight : kOutOfTheWorld;
  const double turn = 0.5 * frame_.camera({}).heading;  // its sides lie along W's axes
  mjtNum* const quaternion = data->mocap_quat + kQuaternion * model->body_mocapid[body_];
  quaternion[0] = std::cos(turn);
  quaternion[3] = std::sin(turn);
}

}  // namespace markservo::simulator
