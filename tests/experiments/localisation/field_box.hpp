#pragma once

#include <Eigen/Core>
#include <vector>

#include "common/robot/robot_description.hpp"

namespace markservo::experiments {

// The rectangle that a field's tags span, sides parallel to W's axes.
struct FieldBox {
  Eigen::Vector2d least = Eigen::Vector2d::Zero();     // m
  Eigen::Vector2d greatest = Eigen::Vector2d::Zero();  // m

  Eigen::Vector2d size() const { return greatest - least; }
  Eigen::Vector2d middle() const { return 0.5 * (least + greatest); }
  // True within `margin` (m) of the rectangle too.
  bool contains(const Eigen::Vector2d& p_W, double margin) const {
    return (p_W.array() >= least.array() - margin).all() && (p_W.array() <= greatest.array() + margin).all();
  }
};

inline FieldBox field_box(const robot::TagField& field) {
  FieldBox box{field.tags.front().p_W, field.tags.front().p_W};
  for (const auto& tag : field.tags) {
    box.least = box.least.cwiseMin(tag.p_W);
    box.greatest = box.greatest.cwiseMax(tag.p_W);
  }
  return box;
}

}  // namespace markservo::experiments
