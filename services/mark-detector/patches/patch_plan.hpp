#pragma once

// Where patches lie and how far they are averaged down, so that all of a pair fit a message.

#include <cstdint>
#include <vector>

#include "services/mark-detector/blobs/shape.hpp"

namespace markservo::mark_detector {

struct PatchParameters {
  int margin = 8;         // px around the mark's box: half a matching window of 15 px
  int margin_pixels = 5;  // patch pixels around the box at least: what an outline is told by
  int limit = 128;        // patch pixels a side
  std::int64_t budget =
      131072;  // bytes of all patches of one image pair: a message that survives default socket buffers
};

// Where a patch lies, before it is cut.
struct PatchFrame {
  int x = 0;
  int y = 0;
  int scale = 0;
  int width = 0;
  int height = 0;

  std::int64_t bytes() const {
    return static_cast<std::int64_t>(height) * (static_cast<std::int64_t>(width) * 3 + (width + 7) / 8);
  }
};

// The frame around `box` and its margin at that scale, as far as the image reaches. `scale` at least 1 and at most the
// image's smaller side.
PatchFrame frame_patch(const Shape& box, const PatchParameters& parameters, int scale, int image_width,
                       int image_height);

// A pair of boxes to be cut at one common scale.
struct PatchRequest {
  Shape left;
  Shape right;
};

// What patches are cut at. Keeps its memory.
struct PatchPlan {
  std::vector<int> scales;             // of each request's pair, 0 for no patch
  std::vector<std::int64_t> reserved;  // bytes of each, at least
};

// The scale of each request's pair. Requests come in order of importance: each takes the least scale
// that keeps within the limit and the budget, less 32 patch pixels a side for each that comes after.
void plan_scales(const std::vector<PatchRequest>& requests, const PatchParameters& parameters, int image_width,
                 int image_height, PatchPlan& plan);

}  // namespace markservo::mark_detector
