#pragma once

// Fills what a blob encloses: dirt, glare and print belong to the mark.

#include <cstdint>
#include <vector>

#include "services/mark-detector/blobs/labelled_runs.hpp"

namespace markservo::mark_detector {

// Keeps its memory from blob to blob.
class HoleFiller {
 public:
  // The runs with holes of at most `max_hole` px filled; a hole is background that the blob, connected over corners,
  // encloses.
  void fill(RunSpan blob, std::int64_t max_hole, std::vector<PixelRun>& filled);

 private:
  BitMask background_;
  LabelledRuns labelled_;
  std::vector<PixelRun> runs_;
};

}  // namespace markservo::mark_detector
