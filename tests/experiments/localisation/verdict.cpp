#include "tests/experiments/localisation/verdict.hpp"

#include <cmath>
#include <cstdio>

namespace markservo::experiments {

void print_verdict(const Verdict& verdict, const std::string& subject) {
  char bar[64];
  if (!std::isfinite(verdict.least)) {
    std::snprintf(bar, sizeof bar, "at most %g", verdict.most);
  } else if (!std::isfinite(verdict.most)) {
    std::snprintf(bar, sizeof bar, "at least %g", verdict.least);
  } else {
    std::snprintf(bar, sizeof bar, "%g to %g", verdict.least, verdict.most);
  }
  std::printf("%-7s ", verdict.met() ? "met" : "missed");
  if (!subject.empty()) std::printf("%-21s ", subject.c_str());
  std::printf("%s: %.2f %s (%s)\n", verdict.what.c_str(), verdict.value, verdict.unit.c_str(), bar);
}

}  // namespace markservo::experiments
