#pragma once

// The books on the shelf as MuJoCo's MJCF.

#include <Eigen/Geometry>
#include <string>

#include "common/robot/robot_description.hpp"
#include "services/simulator/scene/books_settings.hpp"
#include "services/simulator/scene/scene.hpp"

namespace markservo::simulator {

// Where a book stands at a reset: X_SB of its centre.
Eigen::Isometry3d book_pose(const Scene& scene, const BooksSettings& settings, const BookScene& book);

// The body of a book with its mark; body and box are named after the mark. Needs the material matt.
std::string book_body(const robot::RobotDescription& robot, const Scene& scene, const BooksSettings& settings,
                      const BookScene& book);

}  // namespace markservo::simulator
