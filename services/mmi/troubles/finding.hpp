#pragma once

#include <vector>

#include "services/mmi/troubles/trouble.hpp"

namespace markservo::mmi {

// A sign of a trouble at a moment.
struct Finding {
  Trouble trouble;
  double since = 0.0;  // s of the watch's clock: when it began
};

using Findings = std::vector<Finding>;

}  // namespace markservo::mmi
