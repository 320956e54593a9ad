#pragma once

// Connected regions of a mask, by run-length labelling.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "services/mark-detector/bit_mask.hpp"

namespace markservo::mark_detector {

// Pixels [begin, end) of row v.
struct PixelRun {
  int v = 0;
  int begin = 0;
  int end = 0;
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
  std::vector<PixelRun> runs;  // by rows, then columns
};

enum class Connectivity { kFour, kEight };

struct BlobParameters {
  Connectivity connectivity = Connectivity::kEight;
  int64_t min_area = 1;          // px
  std::size_t max_blobs = 1024;  // the largest are kept: bounds what a speckled image can cost
};

struct BlobList {
  std::vector<Blob> blobs;   // at least min_area, the largest first, equal ones from top left
  int64_t largest_area = 0;  // px, of the largest region, kept or not
};

BlobList find_blobs(const BitMask& mask, const BlobParameters& parameters);

// The shape of what the runs cover; they must not overlap. All zero for none.
Shape shape_of(const std::vector<PixelRun>& runs);

// All runs of all blobs as one blob, ordered.
Blob merge(const std::vector<Blob>& blobs);

// The runs with holes of at most `max_hole` px filled; a hole is background that the blob, connected over corners,
// encloses.
std::vector<PixelRun> fill_holes(const Blob& blob, int64_t max_hole);

}  // namespace markservo::mark_detector
