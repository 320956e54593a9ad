#include "services/simulator/world/world.hpp"

#include <mujoco/mujoco.h>

#include <utility>

#include "services/simulator/contacts/box_contacts.hpp"
#include "services/simulator/model/scene_model.hpp"
#include "services/simulator/model/time_step.hpp"

namespace markservo::simulator {
namespace {

constexpr double kSettlingTime = 0.3;  // s, for the books to come to rest on the shelf

Physics build(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings, std::uint64_t seed) {
  check_against_robot(settings, robot);
  drop_impossible_box_contacts();
  return Physics(write_scene_model(robot, scene, settings, seed));
}

}  // namespace

World::World(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings, std::uint64_t seed)
    : World(robot, scene, settings, build(robot, scene, settings, seed),
            SceneFrame(scene.dock.X_WD(), robot.cameras.p_RC)) {}

World::World(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings, Physics physics,
             const SceneFrame& frame)
    : physics_(std::move(physics)),
      base_(model(), data(), frame, settings.base.start()),
      arm_(model(), data(), *robot.arm, settings.arm, settings.servo),
      gripper_(model(), data(), robot.arm->gripper, settings.arm.start_opening, settings.gripper),
      obstacle_(model(), frame, scene.room.floor_z),
      books_(model(), scene.books),
      marks_(model(), robot.marks),
      touch_(model()),
      rays_(frame, scene.room.floor_z),
      clearance_(robot, frame, scene.room.floor_z) {
  obstacle_.put(physics_.model(), data(), settings.obstacle);
  marks_.cover(physics_.model(), settings.marks);
  for (int i = 0; i < static_cast<int>(kSettlingTime / kTimeStep); ++i) step();
  touch_.forget();
  mj_step1(model(), data());
  books_.note_heights(model(), data());
  clearance_.survey(model(), data());
}

void World::change(const Settings& settings) {
  arm_.change(settings.servo);
  gripper_.change(settings.gripper);
  obstacle_.put(physics_.model(), data(), settings.obstacle);
  marks_.cover(physics_.model(), settings.marks);
}

void World::command(const ArmCommand& command) {
  arm_.command(command);
  gripper_.command(command);
}

void World::freeze() {
  arm_.freeze();
  gripper_.freeze();
}

void World::step() {
  base_.depart(data(), kTimeStep);
  mj_step1(model(), data());
  touch_.observe(model(), data());
  arm_.drive(data(), kTimeStep);
  gripper_.drive(data(), kTimeStep);
  mj_step2(model(), data());
  base_.arrive(data());
  physics_.require_stable();
}

std::vector<std::optional<double>> World::cast_rays(const std::vector<Ray>& rays_R) {
  return rays_.cast(model(), data(), base_.X_SC(), rays_R);
}

double World::clearance() const {
  return clearance_.at(model(), data(), base_.X_WR());
}

ArmReading World::arm() const {
  ArmReading reading = arm_.reading();
  reading.gripper_opening = gripper_.opening();
  reading.moving = reading.moving || gripper_.moving();
  return reading;
}

WorldTruth World::truth() {
  mj_step1(model(), data());
  touch_.observe(model(), data());
  const Eigen::Isometry3d X_CS = base_.X_SC().inverse();
  WorldTruth truth;
  truth.shaft = arm_.shafts(data());
  truth.p_CG = X_CS * gripper_.p_SG(data());
  truth.gripper_opening = gripper_.true_opening(data());
  truth.arm_touched = touch_.happened();
  truth.touched = touch_.pair();
  truth.bodies = books_.truth(model(), data(), X_CS);
  truth.marks = marks_.truth(data(), X_CS);
  return truth;
}

}  // namespace markservo::simulator
