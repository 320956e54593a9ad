#pragma once

// The books in the MuJoCo model, which contact and friction alone hold, and what is true about them.

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

#include "services/simulator/scene/scene.hpp"

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

struct BodyTruth {
  std::string name;
  Eigen::Isometry3d X_CB = Eigen::Isometry3d::Identity();  // of the body's centre
  double height_gain = 0.0;                                // m, its lowest point above where it stood at the reset
  bool touches_left_finger = false;
  bool touches_right_finger = false;
  bool touches_other = false;
};

class Books {
 public:
  Books(const mjModel_* model, const BooksScene& books);

  // They have come to rest: heights count from where they are. `data` with poses up to date.
  void note_heights(const mjModel_* model, const mjData_* data);

  // In the scene's order; `data` with poses and contacts up to date.
  std::vector<BodyTruth> truth(const mjModel_* model, const mjData_* data, const Eigen::Isometry3d& X_CS) const;

 private:
  struct Book {
    int body = 0;
    double lowest = 0.0;  // m, its lowest point at the reset
  };

  void note_contacts(const mjModel_* model, const mjData_* data, int body, BodyTruth& truth) const;

  std::vector<Book> books_;
  std::array<int, 2> fingers_;  // bodies: left, right
};

}  // namespace markservo::simulator
