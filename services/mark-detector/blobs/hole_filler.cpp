#include "services/mark-detector/blobs/hole_filler.hpp"

#include <algorithm>
#include <cstddef>

#include "services/mark-detector/blobs/shape.hpp"

namespace markservo::mark_detector {
namespace {

// Rows without a gap, one run each, enclose nothing.
bool is_solid(RunSpan runs) {
  for (std::size_t i = 1; i < runs.size(); ++i) {
    if (runs[i].v != runs[i - 1].v + 1) return false;
  }
  return true;
}

// The blob's complement in a mask whose first pixel is (left, top) of the image.
void fill_background(RunSpan blob, int left, int top, BitMask& background) {
  std::size_t next = 0;
  for (int v = 0; v < background.height(); ++v) {
    int begin = 0;
    for (; next < blob.size() && blob[next].v - top == v; ++next) {
      background.set_run(v, begin, blob[next].begin - left);
      begin = blob[next].end - left;
    }
    background.set_run(v, begin, background.width());
  }
}

// Runs that touch become one.
void join_neighbours(const std::vector<PixelRun>& runs, std::vector<PixelRun>& joined) {
  joined.clear();
  for (const PixelRun& run : runs) {
    if (!joined.empty() && joined.back().v == run.v && joined.back().end == run.begin) {
      joined.back().end = run.end;
    } else {
      joined.push_back(run);
    }
  }
}

}  // namespace

void HoleFiller::fill(RunSpan blob, std::int64_t max_hole, std::vector<PixelRun>& filled) {
  filled.assign(blob.begin(), blob.end());
  if (max_hole <= 0 || is_solid(blob)) return;
  // In its box and one pixel around: what is connected to that rim is outside.
  const Shape shape = shape_of(blob);
  const int left = shape.x - 1;
  const int top = shape.y - 1;
  background_.reset(shape.width + 2, shape.height + 2);
  fill_background(blob, left, top, background_);
  labelled_.label(background_, Connectivity::kFour);
  for (std::size_t i = 0; i < labelled_.runs.size(); ++i) {
    const std::size_t region = labelled_.region_of(i);
    const PixelRun& run = labelled_.runs[i];
    // The rim is one region, and the very first: it holds the first run.
    if (region != 0 && labelled_.areas[region] <= max_hole) {
      filled.push_back({run.v + top, run.begin + left, run.end + left});
    }
  }
  if (filled.size() == blob.size()) return;
  std::sort(filled.begin(), filled.end(), before);
  join_neighbours(filled, runs_);
  filled.swap(runs_);
}

}  // namespace markservo::mark_detector
