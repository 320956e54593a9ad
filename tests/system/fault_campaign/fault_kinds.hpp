#pragma once

// The kinds of fault, how often each is drawn, and how its numbers are.

#include <string>
#include <vector>

#include "tests/system/fault_campaign/plan.hpp"
#include "tests/system/fault_campaign/random.hpp"

namespace markservo::campaign {

struct KindOfFault {
  const char* kind;
  double weight;  // how often, against the others'
  // Fills in what the kind looks at.
  void (*draw)(Random& random, FaultPlan& fault);
};

const std::vector<KindOfFault>& kinds_of_fault();

}  // namespace markservo::campaign
