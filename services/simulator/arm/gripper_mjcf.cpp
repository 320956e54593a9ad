#include "services/simulator/arm/gripper_mjcf.hpp"

#include "services/simulator/contacts/contact_classes.hpp"
#include "services/simulator/model/mjcf_writer.hpp"
#include "services/simulator/model/robot_colours.hpp"

namespace markservo::simulator {
namespace {

using Eigen::Vector3d;

std::string finger_body(const robot::ArmDescription& arm, const GripperSettings& settings, const char* name,
                        double side) {
  constexpr double kFingerHeight = 0.016;  // m, across the forearm
  const auto& gripper = arm.gripper;
  const Vector3d centre(side * 0.5 * gripper.finger_thickness,
                        arm.forearm + gripper.finger_beyond_grip_point - 0.5 * gripper.finger_length, 0.0);
  return std::string("<body ") + named(name) + "><joint " + named(name) + " type=\"slide\" axis=\"" + mjcf(side) +
         " 0 0\" range=\"0 " + mjcf(0.5 * gripper.opening_max) + "\" armature=\"0.5\" damping=\"" +
         mjcf(kFingerDamping) + "\"/>\n<geom " + named(name) + " " + at(centre) + " " +
         box({gripper.finger_thickness, gripper.finger_length, kFingerHeight}) + " mass=\"0.02\" " + coloured(kDark) +
         " material=\"matt\" " + kArmContact + " priority=\"1\" condim=\"4\" friction=\"" + mjcf(settings.friction) +
         " 0.01 0.0001\" " + kStiff + "/></body>\n";
}

}  // namespace

std::string gripper_bodies(const robot::ArmDescription& arm, const GripperSettings& settings) {
  return std::string("<site ") + named(kGripSite) + " " + at({0.0, arm.forearm, 0.0}) +
         " size=\"0.001\" rgba=\"0 0 0 0\"/>\n" + finger_body(arm, settings, kFingers[0], -1.0) +
         finger_body(arm, settings, kFingers[1], 1.0);
}

std::string gripper_equality() {
  return std::string("<joint joint1=\"") + kFingers[0] + "\" joint2=\"" + kFingers[1] + "\" solref=\"0.005 1\"/>";
}

}  // namespace markservo::simulator
