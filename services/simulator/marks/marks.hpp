#pragma once

// The marks in the MuJoCo model, and what is true about them.

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/marks/mark_settings.hpp"

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

struct MarkTruth {
  std::string name;
  Eigen::Vector3d p_CM = Eigen::Vector3d::Zero();      // m, centre of the printed face
  Eigen::Vector3d normal_C = Eigen::Vector3d::Zero();  // unit vector out of the print
};

class Marks {
 public:
  // Those of `marks` that the scene has.
  Marks(const mjModel_* model, const std::vector<robot::MarkDescription>& marks);

  // Covers the one that the settings say, and no other.
  void cover(mjModel_* model, const MarkSettings& settings) const;

  // In robot.yaml's order; `data` with poses up to date.
  std::vector<MarkTruth> truth(const mjData_* data, const Eigen::Isometry3d& X_CS) const;

 private:
  struct Mark {
    std::string name;
    int number;  // in robot.yaml, from 1
    int geom;
    int material;
  };
  std::vector<Mark> marks_;
};

}  // namespace markservo::simulator
