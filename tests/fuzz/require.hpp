#pragma once

// How a fuzz target says that an answer is wrong: the fuzzer takes an abort for a finding and keeps the input.

#include <cstdio>
#include <cstdlib>

namespace markservo::fuzz {

inline void require(bool holds, const char* statement) {
  if (holds) return;
  std::fprintf(stderr, "does not hold: %s\n", statement);
  std::abort();
}

}  // namespace markservo::fuzz
