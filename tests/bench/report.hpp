#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "tests/bench/accuracy.hpp"
#include "tests/bench/agreement.hpp"
#include "tests/bench/contenders.hpp"

namespace markservo::bench {

// Medians over the rounds: times in ms per image pair, ratios of times within a round; what was not timed is left out.
nlohmann::ordered_json report_json(const Times& times, const Agreement& agreement, const Accuracy& even_print,
                                   const Accuracy& soft_print, int num_rounds);

// The same for a person.
std::string report_text(const nlohmann::ordered_json& report);

}  // namespace markservo::bench
