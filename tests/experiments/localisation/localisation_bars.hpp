#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/experiments/localisation/case_result.hpp"

namespace markservo::experiments {

// One thing asked of a case, and what it gave, in the unit a person reads.
struct Verdict {
  std::string what;
  double value = 0.0;
  double least = 0.0;
  double most = 0.0;
  std::string unit;

  bool met() const { return value >= least && value <= most; }  // NaN meets nothing
};

// What is asked of a case. `hall_mean` (m): ours on the undisturbed hall; absent: not measured, not compared.
std::vector<Verdict> verdicts(const CaseResult& result, std::optional<double> hall_mean);

}  // namespace markservo::experiments
