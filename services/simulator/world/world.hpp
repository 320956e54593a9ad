#pragma once

// The simulated world: the robot's arm on its base, books that contact and friction alone hold, and what is true about
// them. No clock: the caller steps it. Frame C throughout, wherever the base is, unless a name says otherwise.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/arm/servo_model.hpp"
#include "services/simulator/base/base_body.hpp"
#include "services/simulator/readers/sonar_model.hpp"
#include "services/simulator/scene/scene.hpp"
#include "services/simulator/scene/scene_frame.hpp"
#include "services/simulator/settings/settings.hpp"

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

// Where the joints shall go.
struct ArmCommand {
  robot::JointVector position = robot::JointVector::Zero();     // rad, clamped to the joints' limits
  robot::JointVector speed_limit = robot::JointVector::Zero();  // rad/s, above 0
  double gripper_opening = 0.0;                                 // m, clamped to the gripper's range
  double gripper_force = 0.0;                                   // N, clamped to the gripper's
};

// What the arm's controller knows about itself: its ramps.
struct ArmReading {
  robot::JointVector position = robot::JointVector::Zero();  // rad
  robot::JointVector speed = robot::JointVector::Zero();     // rad/s
  double gripper_opening = 0.0;                              // m
  bool moving = false;
};

struct BodyTruth {
  std::string name;
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();  // of the body's centre
  double height_gain = 0.0;                                // m, its lowest point above where it stood at the reset
  bool touches_left_finger = false;
  bool touches_right_finger = false;
  bool touches_other = false;
};

struct MarkTruth {
  std::string name;
  Eigen::Vector3d p_CM = Eigen::Vector3d::Zero();      // m, centre of the printed face
  Eigen::Vector3d normal_C = Eigen::Vector3d::Zero();  // unit vector out of the print
};

struct WorldTruth {
  robot::JointVector shaft = robot::JointVector::Zero();  // rad, where the joints really are
  Eigen::Vector3d p_CG = Eigen::Vector3d::Zero();         // m
  double gripper_opening = 0.0;                           // m
  bool arm_touched = false;                               // anything, since the reset
  std::string touched;                                    // the first such pair
  std::vector<BodyTruth> bodies;
  std::vector<MarkTruth> marks;  // in robot.yaml's order
};

class World {
 public:
  // Builds the world and lets the books settle. The same arguments give the same world bit for bit. Throws
  // ConfigurationError if robot, scene or settings cannot be simulated.
  World(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings, std::uint64_t seed);
  ~World();
  World(World&&) noexcept;
  World& operator=(World&&) noexcept;

  // Takes over the settings that show at once; the others wait for a new World.
  void change(const Settings& settings);

  void command(const ArmCommand& command);
  // The arm's and the gripper's ramps stop where they are; the grip keeps its force.
  void freeze();

  // Where the base shall be after the next step, X_WR. It begins where the settings start it.
  void move_base(const geometry::PlanePose& X_WR);

  // Lets kTimeStep pass.
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

  // Another one for each World that was ever built in this process.
  std::uint64_t id() const { return id_; }
  const mjModel_* model() const { return model_.get(); }
  mjData_* data() const { return data_.get(); }

 private:
  struct ModelDeleter {
    void operator()(mjModel_* model) const;
  };
  struct DataDeleter {
    void operator()(mjData_* data) const;
  };
  struct JointDrive {
    int qpos = 0;  // address in qpos
    int dof = 0;   // address in qvel
    ServoModel servo{0.0};
  };

  void put_obstacle();
  void drive_joints();
  void drive_gripper();
  void watch_contacts();
  int body_id(const std::string& name) const;
  const char* body_name(int geom) const;
  double lowest_point(int body) const;
  ServoParameters servo_parameters(int joint) const;

  std::uint64_t id_;
  robot::RobotDescription robot_;
  Settings settings_;
  std::unique_ptr<mjModel_, ModelDeleter> model_;
  std::unique_ptr<mjData_, DataDeleter> data_;
  SceneFrame scene_frame_;
  double floor_z_;  // m in S
  std::optional<BaseBody> base_;
  geometry::PlanePose X_WR_;
  std::vector<int> standing_boxes_;
  std::vector<JointDrive> joints_;
  std::vector<JointDrive> fingers_;  // their servo models are unused: the opening's ramp drives both
  std::vector<int> book_bodies_;
  std::vector<double> book_lowest_;  // m, at the reset
  std::vector<bool> is_arm_;         // by body
  int left_finger_ = 0;              // bodies
  int right_finger_ = 0;
  int grip_site_ = 0;
  double opening_target_ = 0.0;  // m
  double opening_ramp_ = 0.0;    // m
  double opening_speed_ = 0.0;   // m/s
  double gripper_force_ = 0.0;   // N
  bool arm_touched_ = false;
  std::string touched_;
};

}  // namespace markservo::simulator
