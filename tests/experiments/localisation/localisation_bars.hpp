#pragma once

#include <optional>
#include <vector>

#include "tests/experiments/localisation/case_result.hpp"
#include "tests/experiments/localisation/verdict.hpp"

namespace markservo::experiments {

// What is asked of a case. `hall_mean` (m): ours on the undisturbed hall; absent: not measured, not compared.
std::vector<Verdict> verdicts(const CaseResult& result, std::optional<double> hall_mean);

}  // namespace markservo::experiments
