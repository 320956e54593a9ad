#pragma once

#include <optional>
#include <string>
#include <vector>

#include "tests/experiments/localisation/case_result.hpp"

namespace markservo::experiments {

// The live pose by cases, and the paper's table 2 beside ours, on the standard output.
void print_cases(const std::vector<CaseResult>& results);
void print_paper_table(const std::vector<CaseResult>& results);

// Every bar with what it gave; true if all are met. `hall_mean` (m): ours on the undisturbed hall, if it was measured.
bool print_verdicts(const std::vector<CaseResult>& results, std::optional<double> hall_mean);

// DIR/localisation.json
void write_localisation_json(const std::vector<CaseResult>& results, const std::string& folder);

}  // namespace markservo::experiments
