#pragma once

// Whether a round's outcome is one that the estimate lets expect.

#include <vector>

namespace markservo::rfid_localizer {

// How much less likely a round's outcome was than such outcomes are on average, in standard deviations of what chance
// does to it: around 0 where the estimate holds, whatever the number of tags. `chances`: of each tag near to be read,
// in [0, 1]; `log_evidence`: the logarithm of the probability of what was read and what was not; `least` (above 0,
// below 0.5): no outcome of a tag is less likely.
double surprise(const std::vector<double>& chances, double log_evidence, double least);

}  // namespace markservo::rfid_localizer
