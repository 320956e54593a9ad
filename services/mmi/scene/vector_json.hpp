#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace markservo::mmi {

// A vector as a list of its numbers.
template <class Derived>
nlohmann::ordered_json vector_json(const Eigen::MatrixBase<Derived>& vector) {
  auto list = nlohmann::ordered_json::array();
  for (Eigen::Index i = 0; i < vector.size(); ++i) list.push_back(vector[i]);
  return list;
}

}  // namespace markservo::mmi
