#pragma once

// Small helpers that write MJCF, MuJoCo's XML.

#include <fmt/format.h>

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <string>

namespace markservo::simulator {

inline std::string mjcf(double value) {
  return fmt::format("{:.12g}", value);
}

inline std::string mjcf(const Eigen::Vector3d& v) {
  return mjcf(v[0]) + " " + mjcf(v[1]) + " " + mjcf(v[2]);
}

inline std::string mjcf(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  return mjcf(q.w()) + " " + mjcf(q.x()) + " " + mjcf(q.y()) + " " + mjcf(q.z());
}

// pos="..." quat="..."
inline std::string placed(const Eigen::Isometry3d& pose) {
  return "pos=\"" + mjcf(Eigen::Vector3d(pose.translation())) + "\" quat=\"" + mjcf(Eigen::Matrix3d(pose.linear())) +
         "\"";
}

inline std::string at(const Eigen::Vector3d& position) {
  return "pos=\"" + mjcf(position) + "\"";
}

// size="..." of a box with these edges.
inline std::string box(const Eigen::Vector3d& edges) {
  return "type=\"box\" size=\"" + mjcf(Eigen::Vector3d(0.5 * edges)) + "\"";
}

inline std::string coloured(const Eigen::Vector3d& rgb) {
  return "rgba=\"" + mjcf(rgb) + " 1\"";
}

inline std::string named(const std::string& name) {
  return "name=\"" + name + "\"";
}

}  // namespace markservo::simulator
