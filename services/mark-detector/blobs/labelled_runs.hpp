#pragma once

// Connected regions of a mask, by run-length labelling.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/imaging/bit_mask.hpp"
#include "services/mark-detector/blobs/pixel_run.hpp"

namespace markservo::mark_detector {

using imaging::BitMask;

enum class Connectivity { kFour, kEight };

// Runs with their regions. Keeps its memory from mask to mask.
struct LabelledRuns {
  std::vector<PixelRun> runs;        // by rows, then columns
  std::vector<std::int32_t> labels;  // of each run: its region's first run
  std::vector<std::int64_t> areas;   // px, of each region, at its first run; else 0

  void label(const BitMask& mask, Connectivity connectivity);

  // The region of a run: the number of its first run.
  std::size_t region_of(std::size_t run) const { return static_cast<std::size_t>(labels[run]); }
};

}  // namespace markservo::mark_detector
