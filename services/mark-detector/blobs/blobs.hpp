#pragma once

// Connected regions of a mask, by run-length labelling.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/imaging/bit_mask.hpp"

namespace markservo::mark_detector {

using imaging::BitMask;

// Pixels [begin, end) of row v.
struct PixelRun {
  int v = 0;
  int begin = 0;
  int end = 0;
};

// Runs that belong to somebody else.
class RunSpan {
 public:
  RunSpan() = default;
  RunSpan(const PixelRun* first, std::size_t count) : first_(first), count_(count) {}
  RunSpan(const std::vector<PixelRun>& runs) : RunSpan(runs.data(), runs.size()) {}  // NOLINT: as good as the runs

  const PixelRun* begin() const { return first_; }
  const PixelRun* end() const { return first_ + count_; }
  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  const PixelRun& front() const { return *first_; }
  const PixelRun& operator[](std::size_t i) const { return first_[i]; }

 private:
  const PixelRun* first_ = nullptr;
  std::size_t count_ = 0;
};

// Where pixels are, px of the image. Moments are about the centroid.
struct Shape {
  int x = 0;  // box: left column
  int y = 0;  // box: top row
  int width = 0;
  int height = 0;
  double area = 0.0;  // px^2
  double u = 0.0;     // centroid
  double v = 0.0;
  double m_uu = 0.0;  // px^2, second moments
  double m_uv = 0.0;
  double m_vv = 0.0;
};

struct Blob {
  Shape shape;
  std::size_t first_run = 0;  // of the list's runs
  std::size_t num_runs = 0;
};

enum class Connectivity { kFour, kEight };

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

// Runs with their regions.
struct LabelledRuns {
  std::vector<PixelRun> runs;        // by rows, then columns
  std::vector<std::int32_t> labels;  // of each run: its region's first run
  std::vector<std::int64_t> areas;   // px, of each region, at its first run; else 0

  void label(const BitMask& mask, Connectivity connectivity);
};

// Keeps its memory from mask to mask.
class BlobFinder {
 public:
  void find(const BitMask& mask, const BlobParameters& parameters, BlobList& list);

 private:
  LabelledRuns labelled_;
  std::vector<std::size_t> kept_;
  std::vector<std::size_t> rank_;
};

// The same once.
BlobList find_blobs(const BitMask& mask, const BlobParameters& parameters);

// The shape of what the runs cover; they must not overlap. All zero for none.
Shape shape_of(RunSpan runs);

// All runs of all blobs, ordered as one blob's.
void merge(const BlobList& list, std::vector<PixelRun>& runs);

// Fills what a blob encloses. Keeps its memory from blob to blob.
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
