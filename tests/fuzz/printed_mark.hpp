#pragma once

// The two views of a printed mark from a few bytes, as the locator is given them: usual ones without any bytes.

#include <fuzzer/FuzzedDataProvider.h>

#include <cstdint>
#include <vector>

#include "services/target-locator/mark_observation.hpp"

namespace markservo::fuzz {

// A patch that owns its bytes, in memory of exactly their number, so that reading past the end is noticed.
struct PrintedPatch {
  int width = 0;   // patch pixels
  int height = 0;  // patch pixels
  std::vector<std::uint8_t> bgr;
  std::vector<std::uint8_t> mask;  // a bit a pixel, rows padded to bytes, lowest bit first
};

struct PrintedMark {
  target_locator::MarkObservation observation;  // points into the patches below
  PrintedPatch left;
  PrintedPatch right;

  PrintedMark() = default;
  PrintedMark(const PrintedMark&) = delete;
  PrintedMark& operator=(const PrintedMark&) = delete;
};

// Fills `mark`. `whole_numbers`: frames and boxes as a message can carry them, in 32-bit integers; else any numbers,
// NaN among them.
void print_mark(FuzzedDataProvider& data, bool whole_numbers, PrintedMark& mark);

}  // namespace markservo::fuzz
