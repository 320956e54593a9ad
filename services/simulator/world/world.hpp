#pragma once

// The simulated world: the robot's arm on its base, books that contact and friction alone hold, and what is true about
// them. No clock: the caller steps it. Frame C throughout, wherever the base is, unless a name says otherwise.

#include <cstdint>
#include <optional>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/arm/arm.hpp"
#include "services/simulator/arm/gripper.hpp"
#include "services/simulator/base/base_body.hpp"
#include "services/simulator/contacts/arm_touch.hpp"
#include "services/simulator/contacts/clearance.hpp"
#include "services/simulator/marks/marks.hpp"
#include "services/simulator/model/physics.hpp"
#include "services/simulator/readers/ray_caster.hpp"
#include "services/simulator/scene/books.hpp"
#include "services/simulator/scene/obstacle.hpp"
#include "services/simulator/scene/scene.hpp"
#include "services/simulator/settings/settings.hpp"
#include "services/simulator/world/world_truth.hpp"

namespace markservo::simulator {

class World {
 public:
  // Builds the world and lets the books settle. The same arguments give the same world bit for bit. Throws
  // ConfigurationError if robot, scene or settings cannot be simulated.
  World(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings, std::uint64_t seed);

  // Takes over the settings that show at once; the others wait for a new World.
  void change(const Settings& settings);

  void command(const ArmCommand& command);
  // The arm's and the gripper's ramps stop where they are; the grip keeps its force.
  void freeze();

  // Where the base shall be after the next step, X_WR. It begins where the settings start it.
  void move_base(const geometry::PlanePose& X_WR) { base_.aim(X_WR); }

  // Lets kTimeStep pass. Throws std::runtime_error if the physics diverged.
  void step();

  ArmReading arm() const;
  // What is true now. Also brings the model's poses up to date for drawing.
  WorldTruth truth();

  // m, how far each ray from the robot, in R, goes until it meets something that is not the robot; nothing if it never
  // does.
  std::vector<std::optional<double>> cast_rays(const std::vector<Ray>& rays_R);
  // m, from the base's outline to the nearest thing that stands on the floor; 0 if they touch. Of a robot without a
  // base: infinity.
  double clearance() const;

  // To be drawn, as it was at the last truth().
  const Physics& physics() const { return physics_; }

 private:
  World(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings, Physics physics,
        const SceneFrame& frame);

  const mjModel_* model() const { return physics_.model(); }
  mjData_* data() const { return physics_.data(); }

  Physics physics_;
  BaseBody base_;
  Arm arm_;
  Gripper gripper_;
  Obstacle obstacle_;
  Books books_;
  Marks marks_;
  ArmTouch touch_;
  RayCaster rays_;
  Clearance clearance_;
};

}  // namespace markservo::simulator
