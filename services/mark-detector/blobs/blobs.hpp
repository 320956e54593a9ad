#pragma once

// The connected regions of a mask that are large enough, with their shapes.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "services/mark-detector/blobs/labelled_runs.hpp"
#include "services/mark-detector/blobs/shape.hpp"

namespace markservo::mark_detector {

struct Blob {
  Shape shape;
  std::size_t first_run = 0;  // of the list's runs
  std::size_t num_runs = 0;
};

struct BlobParameters {
  Connectivity connectivity = Connectivity::kEight;
  std::int64_t min_area = 1;     // px
  std::size_t max_blobs = 1024;  // the largest are kept: bounds what a speckled image can cost
};

struct BlobList {
  std::vector<Blob> blobs;        // at least min_area, the largest first, equal ones from top left
  std::vector<PixelRun> runs;     // of all blobs, one after the other; of each by rows, then columns
  std::int64_t largest_area = 0;  // px, of the largest region, kept or not

  RunSpan runs_of(const Blob& blob) const { return {runs.data() + blob.first_run, blob.num_runs}; }
};

// Keeps its memory from mask to mask.
class BlobFinder {
 public:
  void find(const BitMask& mask, const BlobParameters& parameters, BlobList& list);

 private:
  void choose(const BlobParameters& parameters, BlobList& list);
  void collect_runs(BlobList& list);

  LabelledRuns labelled_;
  std::vector<std::size_t> kept_;  // regions, in the order of the list
  std::vector<std::size_t> rank_;  // of each region, its place in `kept_`
};

// The same for one mask, without memory.
BlobList find_blobs(const BitMask& mask, const BlobParameters& parameters);

// Puts all runs of all blobs into `runs`, ordered as one blob's.
void merge(const BlobList& list, std::vector<PixelRun>& runs);

}  // namespace markservo::mark_detector
