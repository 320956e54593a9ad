#pragma once

#include <string>

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

// A line on the standard output: whether it is met, `subject` in a column of its own unless it is empty, what was asked
// and what it gave.
void print_verdict(const Verdict& verdict, const std::string& subject = "");

}  // namespace markservo::experiments
