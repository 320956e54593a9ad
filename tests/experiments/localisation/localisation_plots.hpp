#pragma once

#include <string>

#include "tests/experiments/localisation/case_result.hpp"

namespace markservo::experiments {

// Of a case's first run, by gnuplot; without gnuplot a line says so.
// DIR/localisation-NAME-errors.svg: the error of x_m and x_com and ours over the course, per axis, as the paper's
// figures 9 and 10.
void plot_errors(const CaseResult& result, const std::string& folder);
// DIR/localisation-NAME-plan.svg: tags, true way, the weighted averages and our estimates from above.
void plot_plan(const CaseResult& result, const std::string& folder);

}  // namespace markservo::experiments
