#include "services/simulator/base/base_mjcf.hpp"

#include "services/simulator/contacts/contact_classes.hpp"
#include "services/simulator/model/mjcf_writer.hpp"
#include "services/simulator/model/robot_colours.hpp"

namespace markservo::simulator {
namespace {

using Eigen::Vector3d;

// The base's inertia in the model, kg and kg m2: no force there is moves it.
constexpr double kBaseInertia = 1e6;

}  // namespace

std::string robot_body(const robot::RobotDescription& robot, double floor_z, const std::string& carried) {
  constexpr double kGroundClearance = 0.06;  // m
  const Vector3d p_RC = robot.cameras.p_RC;
  const double plate_z = robot.arm->p_CA.z();
  const double body_height = plate_z - floor_z - kGroundClearance;
  Vector3d size(0.36, 0.40, body_height);
  Vector3d centre(robot.arm->p_CA.x(), robot.arm->p_CA.y() - 0.14, plate_z - 0.5 * body_height);
  if (robot.base) {
    size.head<2>() << 2.0 * robot.base->half_width, robot.base->front + robot.base->rear;
    centre.head<2>() << p_RC.y(), 0.5 * (robot.base->front - robot.base->rear) - p_RC.x();
  }
  std::string out = std::string("<body ") + named(kRobotBase) + ">\n";
  const auto joint = [&](const char* name, const char* kind_and_axis) {
    out += std::string("<joint ") + named(name) + " " + kind_and_axis + " armature=\"" + mjcf(kBaseInertia) + "\"/>\n";
  };
  joint(kBaseJoints[0], "type=\"slide\" axis=\"1 0 0\"");
  joint(kBaseJoints[1], "type=\"slide\" axis=\"0 1 0\"");
  joint(kBaseJoints[2], "type=\"hinge\" axis=\"0 0 1\"");
  out += "<geom name=\"robot_base\" " + at(centre) + " " + box(size) + " " + coloured({0.24, 0.25, 0.27}) +
         " material=\"matt\" " + kBaseContact + "/>\n";
  out += "<geom name=\"mast\" " + at({0.5 * robot.cameras.stereo.baseline, -0.16, 0.5 * plate_z}) + " " +
         box({0.03, 0.03, -plate_z}) + " " + coloured(kMetal) + " material=\"matt\" " + kBaseContact + "/>\n";
  return out + carried + "</body>\n";
}

}  // namespace markservo::simulator
