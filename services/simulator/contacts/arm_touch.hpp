#pragma once

#include <string>
#include <vector>

struct mjModel_;
struct mjData_;

namespace markservo::simulator {

// Whether the arm has touched anything that is not the arm, and what first.
class ArmTouch {
 public:
  explicit ArmTouch(const mjModel_* model);

  // `data` with contacts up to date.
  void observe(const mjModel_* model, const mjData_* data);
  void forget();

  bool happened() const { return happened_; }
  // "part of the arm - other thing"; empty before.
  const std::string& pair() const { return pair_; }

 private:
  const char* name_of(const mjModel_* model, int geom) const;

  int robot_base_;            // body
  std::vector<bool> is_arm_;  // by body
  bool happened_ = false;
  std::string pair_;
};

}  // namespace markservo::simulator
