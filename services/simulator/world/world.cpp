#include "services/simulator/world/world.hpp"

#include <mujoco/mujoco.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "common/robot/configuration_error.hpp"
#include "services/simulator/arm/arm_mjcf.hpp"
#include "services/simulator/arm/gripper_mjcf.hpp"
#include "services/simulator/base/base_mjcf.hpp"
#include "services/simulator/contacts/box_contacts.hpp"
#include "services/simulator/contacts/surroundings.hpp"
#include "services/simulator/degrees.hpp"
#include "services/simulator/marks/mark_mjcf.hpp"
#include "services/simulator/model/scene_model.hpp"
#include "services/simulator/model/time_step.hpp"
#include "services/simulator/scene/obstacle.hpp"

namespace markservo::simulator {
namespace {

// The drive that makes the arm follow its servos' shafts: with the joints' armature of 0.15 kg m2 and damping of
// 60 N m s critically damped at 200 rad/s; a book at arm's length bends it by 0.01 degrees.
constexpr double kJointStiffness = 6000.0;  // N m/rad
constexpr double kJointTorqueMax = 200.0;   // N m, keeps a collision finite

constexpr double kFingerStiffness = 20000.0;  // N/m

constexpr double kSettlingTime = 0.3;  // s, for the books to come to rest on the shelf

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

// Numbers a vector, a rotation matrix and a quaternion take in MuJoCo's arrays.
constexpr std::ptrdiff_t kVector = 3;
constexpr std::ptrdiff_t kMatrix = 9;
constexpr std::ptrdiff_t kQuaternion = 4;

Eigen::Vector3d vector(const mjtNum* v) {
  return {v[0], v[1], v[2]};
}

Eigen::Matrix3d matrix(const mjtNum* m) {
  return Eigen::Map<const Eigen::Matrix<mjtNum, 3, 3, Eigen::RowMajor>>(m);
}

}  // namespace

void World::ModelDeleter::operator()(mjModel_* model) const {
  mj_deleteModel(model);
}
void World::DataDeleter::operator()(mjData_* data) const {
  mj_deleteData(data);
}

World::World(World&&) noexcept = default;
World& World::operator=(World&&) noexcept = default;
World::~World() = default;

World::World(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings, std::uint64_t seed)
    : id_(next_id()),
      robot_(robot),
      settings_(settings),
      scene_frame_(scene.dock.X_WD(), robot.cameras.p_RC),
      floor_z_(scene.room.floor_z),
      X_WR_(settings.base.start()) {
  check_against_robot(settings, robot);
  drop_impossible_box_contacts();
  // MuJoCo would write a log file into the working folder; step() looks at the warnings' counters instead.
  mju_user_warning = [](const char*) {};
  const SceneModel scene_model = write_scene_model(robot, scene, settings, seed);
  model_.reset(compile(scene_model));
  paint(model_.get(), scene_model);
  data_.reset(mj_makeData(model_.get()));
  base_.emplace(model_.get());
  base_->put(data_.get(), scene_frame_.camera(X_WR_));
  put_obstacle();

  const double start_deg[] = {settings.arm.start_yaw_deg, settings.arm.start_shoulder_deg,
                              settings.arm.start_elbow_deg};
  const auto drive = [this](const char* name, double start) {
    const int joint = mj_name2id(model_.get(), mjOBJ_JOINT, name);
    JointDrive result{model_->jnt_qposadr[joint], model_->jnt_dofadr[joint], ServoModel(start)};
    data_->qpos[result.qpos] = start;
    return result;
  };
  for (int i = 0; i < robot::kNumJoints; ++i) joints_.push_back(drive(kArmJoints[i], start_deg[i] * kRadiansPerDegree));
  for (const char* name : kFingers) fingers_.push_back(drive(name, 0.5 * settings.arm.start_opening));
  opening_target_ = opening_ramp_ = settings.arm.start_opening;
  gripper_force_ = robot.arm->gripper.force_max;

  left_finger_ = body_id(kFingers[0]);
  right_finger_ = body_id(kFingers[1]);
  grip_site_ = mj_name2id(model_.get(), mjOBJ_SITE, kGripSite);
  is_arm_.assign(static_cast<std::size_t>(model_->nbody), false);
  const int column = body_id(kArmColumn);
  for (int body = column; body < model_->nbody; ++body) {
    const int parent = model_->body_parentid[body];
    is_arm_[static_cast<std::size_t>(body)] = body == column || is_arm_[static_cast<std::size_t>(parent)];
  }
  for (const BookScene& book : scene.books.row) book_bodies_.push_back(body_id(book.mark));

  for (int i = 0; i < static_cast<int>(kSettlingTime / kTimeStep); ++i) step();
  arm_touched_ = false;
  touched_.clear();
  mj_step1(model_.get(), data_.get());
  for (const int body : book_bodies_) book_lowest_.push_back(lowest_point(body));
  if (robot.base) standing_boxes_ = standing_boxes(model_.get(), data_.get(), floor_z_ + 0.001, robot.arm->p_CA.z());
}

int World::body_id(const std::string& name) const {
  return mj_name2id(model_.get(), mjOBJ_BODY, name.c_str());
}

void World::change(const Settings& settings) {
  settings_.servo = settings.servo;
  settings_.gripper = settings.gripper;
  settings_.obstacle = settings.obstacle;
  put_obstacle();
}

void World::put_obstacle() {
  constexpr double kOutOfTheWorld = -100.0;  // m, z
  const int body = body_id(kObstacle);
  const int geom = model_->body_geomadr[body];
  mjtNum* const half = model_->geom_size + kVector * geom;
  half[0] = half[1] = 0.5 * settings_.obstacle.size;
  model_->geom_rbound[geom] = vector(half).norm();
  const Eigen::Vector2d p_S = scene_frame_.place({settings_.obstacle.x, settings_.obstacle.y});
  mjtNum* const position = data_->mocap_pos + kVector * model_->body_mocapid[body];
  position[0] = p_S.x();
  position[1] = p_S.y();
  position[2] = settings_.obstacle.present != 0.0 ? floor_z_ + 0.5 * kObstacleHeight : kOutOfTheWorld;
  const double turn = 0.5 * scene_frame_.camera({}).heading;  // its sides lie along W's axes
  mjtNum* const quaternion = data_->mocap_quat + kQuaternion * model_->body_mocapid[body];
  quaternion[0] = std::cos(turn);
  quaternion[3] = std::sin(turn);
}

void World::move_base(const geometry::PlanePose& X_WR) {
  X_WR_ = X_WR;
  base_->aim(scene_frame_.camera(X_WR));
}

void World::command(const ArmCommand& command) {
  const robot::ArmDescription& arm = *robot_.arm;
  for (int i = 0; i < robot::kNumJoints; ++i) {
    const auto& joint = arm.joints[static_cast<std::size_t>(i)];
    joints_[static_cast<std::size_t>(i)].servo.command(std::clamp(command.position[i], joint.min, joint.max),
                                                       command.speed_limit[i]);
  }
  opening_target_ = std::clamp(command.gripper_opening, 0.0, arm.gripper.opening_max);
  gripper_force_ = std::clamp(command.gripper_force, 0.0, arm.gripper.force_max);
}

void World::freeze() {
  for (JointDrive& joint : joints_) joint.servo.freeze();
  opening_target_ = opening_ramp_;
}

ServoParameters World::servo_parameters(int joint) const {
  ServoParameters parameters;
  parameters.speed = settings_.servo.speed_deg_s > 0.0 ? settings_.servo.speed_deg_s * kRadiansPerDegree
                                                       : robot_.arm->joints[static_cast<std::size_t>(joint)].speed;
  parameters.acceleration = settings_.servo.acceleration_deg_s2 * kRadiansPerDegree;
  parameters.deadband = settings_.servo.deadband_deg * kRadiansPerDegree;
  parameters.deadband_kind =
      settings_.servo.deadband_kind == 0.0 ? DeadbandKind::kStopsAtEdge : DeadbandKind::kRunsHome;
  parameters.backlash = settings_.servo.backlash_deg * kRadiansPerDegree;
  return parameters;
}

void World::drive_joints() {
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    JointDrive& joint = joints_[i];
    // The joint is where the step begins: against the shaft at its end it would run ahead by a step.
    const double behind = joint.servo.shaft() - data_->qpos[joint.qpos];
    joint.servo.advance(servo_parameters(static_cast<int>(i)), kTimeStep);
    const double torque = kJointStiffness * behind + kJointDamping * joint.servo.shaft_speed();
    // qfrc_bias carries weight and gyroscopic forces: the drive holds the arm's own weight without bending.
    data_->qfrc_applied[joint.dof] =
        std::clamp(torque, -kJointTorqueMax, kJointTorqueMax) + data_->qfrc_bias[joint.dof];
  }
}

void World::drive_gripper() {
  const double step = settings_.gripper.speed * kTimeStep;
  const double change = std::clamp(opening_target_ - opening_ramp_, -step, step);
  opening_ramp_ += change;
  opening_speed_ = change / kTimeStep;
  for (const JointDrive& finger : fingers_) {
    const double force =
        kFingerStiffness * (0.5 * opening_ramp_ - data_->qpos[finger.qpos]) + kFingerDamping * 0.5 * opening_speed_;
    data_->qfrc_applied[finger.dof] = std::clamp(force, -gripper_force_, gripper_force_) + data_->qfrc_bias[finger.dof];
  }
}

void World::step() {
  base_->depart(data_.get(), kTimeStep);
  mj_step1(model_.get(), data_.get());
  watch_contacts();
  drive_joints();
  drive_gripper();
  mj_step2(model_.get(), data_.get());
  base_->arrive(data_.get());
  // MuJoCo answers divergence by putting its own state back to the start, silently: that must never pass as physics.
  for (const int warning : {mjWARN_BADQPOS, mjWARN_BADQVEL, mjWARN_BADQACC}) {
    if (data_->warning[warning].number > 0) throw std::runtime_error("the simulated physics diverged");
  }
}

const char* World::body_name(int geom) const {
  const int body = model_->geom_bodyid[geom];
  const bool of_many_parts = body == 0 || body == body_id(kRobotBase);
  const char* name =
      of_many_parts ? mj_id2name(model_.get(), mjOBJ_GEOM, geom) : mj_id2name(model_.get(), mjOBJ_BODY, body);
  return name == nullptr ? "unnamed" : name;
}

void World::watch_contacts() {
  if (arm_touched_) return;
  for (int i = 0; i < data_->ncon; ++i) {
    const mjContact& contact = data_->contact[i];
    const auto body1 = static_cast<std::size_t>(model_->geom_bodyid[contact.geom1]);
    const auto body2 = static_cast<std::size_t>(model_->geom_bodyid[contact.geom2]);
    if (is_arm_[body1] == is_arm_[body2]) continue;
    arm_touched_ = true;
    const int arm_geom = is_arm_[body1] ? contact.geom1 : contact.geom2;
    const int other_geom = is_arm_[body1] ? contact.geom2 : contact.geom1;
    touched_ = std::string(body_name(arm_geom)) + " - " + body_name(other_geom);
    return;
  }
}

std::vector<std::optional<double>> World::cast_rays(const std::vector<Ray>& rays_R) {
  mj_kinematics(model_.get(), data_.get());
  const Eigen::Isometry3d X_SC = base_->X_SC();
  std::vector<Ray> rays_S;
  rays_S.reserve(rays_R.size());
  for (const Ray& ray : rays_R) {
    const Eigen::Vector2d p_C = scene_frame_.in_camera(ray.origin.head<2>());
    const Eigen::Vector3d direction_C(-ray.direction.y(), ray.direction.x(), ray.direction.z());
    rays_S.push_back(
        {X_SC * Eigen::Vector3d(p_C.x(), p_C.y(), floor_z_ + ray.origin.z()), X_SC.linear() * direction_C});
  }
  return simulator::cast_rays(model_.get(), data_.get(), rays_S);
}

double World::clearance() const {
  double nearest = std::numeric_limits<double>::infinity();
  if (!robot_.base) return nearest;
  const robot::BaseDescription& base = *robot_.base;
  const Eigen::Vector2d half(0.5 * (base.front + base.rear), base.half_width);
  const Eigen::Vector2d middle = X_WR_ * Eigen::Vector2d(0.5 * (base.front - base.rear), 0.0);
  const Footprint outline{scene_frame_.place(middle), half, scene_frame_.forward(X_WR_)};
  for (const int box : standing_boxes_) {
    const Footprint other = footprint_of(model_.get(), data_.get(), box);
    const bool there = data_->geom_xpos[kVector * box + 2] > floor_z_;
    if (there) nearest = std::min(nearest, distance(outline, other));
  }
  return nearest;
}

ArmReading World::arm() const {
  ArmReading reading;
  for (std::size_t i = 0; i < joints_.size(); ++i) {
    const auto row = static_cast<Eigen::Index>(i);
    reading.position[row] = joints_[i].servo.ramp();
    reading.speed[row] = joints_[i].servo.ramp_speed();
    reading.moving = reading.moving || joints_[i].servo.moving();
  }
  reading.gripper_opening = opening_ramp_;
  reading.moving = reading.moving || opening_ramp_ != opening_target_;
  return reading;
}

double World::lowest_point(int body) const {
  const int geom = model_->body_geomadr[body];  // the first geom is the book's box
  const Eigen::Vector3d half = vector(model_->geom_size + kVector * geom);
  const Eigen::Matrix3d R = matrix(data_->geom_xmat + kMatrix * geom);
  return data_->geom_xpos[kVector * geom + 2] - R.row(2).cwiseAbs().dot(half);
}

WorldTruth World::truth() {
  mj_step1(model_.get(), data_.get());
  watch_contacts();
  const Eigen::Isometry3d X_CS = base_->X_SC().inverse();
  WorldTruth truth;
  for (std::size_t i = 0; i < joints_.size(); ++i)
    truth.shaft[static_cast<Eigen::Index>(i)] = data_->qpos[joints_[i].qpos];
  truth.p_CG = X_CS * vector(data_->site_xpos + kVector * grip_site_);
  for (const JointDrive& finger : fingers_) truth.gripper_opening += data_->qpos[finger.qpos];
  truth.arm_touched = arm_touched_;
  truth.touched = touched_;

  for (std::size_t i = 0; i < book_bodies_.size(); ++i) {
    const int body = book_bodies_[i];
    BodyTruth book;
    book.name = mj_id2name(model_.get(), mjOBJ_BODY, body);
    book.X_CB.translation() = X_CS * vector(data_->xpos + kVector * body);
    book.X_CB.linear() = X_CS.linear() * matrix(data_->xmat + kMatrix * body);
    book.height_gain = lowest_point(body) - book_lowest_[i];
    for (int c = 0; c < data_->ncon; ++c) {
      const int body1 = model_->geom_bodyid[data_->contact[c].geom1];
      const int body2 = model_->geom_bodyid[data_->contact[c].geom2];
      if (body1 != body && body2 != body) continue;
      const int other = body1 == body ? body2 : body1;
      if (other == left_finger_) {
        book.touches_left_finger = true;
      } else if (other == right_finger_) {
        book.touches_right_finger = true;
      } else {
        book.touches_other = true;
      }
    }
    truth.bodies.push_back(std::move(book));
  }

  for (const auto& description : robot_.marks) {
    const int geom = mj_name2id(model_.get(), mjOBJ_GEOM, print_name(description.name).c_str());
    if (geom < 0) continue;  // a mark of robot.yaml that this scene does not have
    MarkTruth mark;
    mark.name = description.name;
    mark.normal_C = X_CS.linear() * matrix(data_->geom_xmat + kMatrix * geom).col(2);
    mark.p_CM = X_CS * vector(data_->geom_xpos + kVector * geom) + 0.5 * kPrintThickness * mark.normal_C;
    truth.marks.push_back(std::move(mark));
  }
  return truth;
}

}  // namespace markservo::simulator
