#pragma once

// Patches for matching: a mark's surroundings, small enough to send.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "services/mark-detector/blobs/region.hpp"
#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

struct PatchParameters {
  int margin = 8;         // px around the mark's box: half a matching window of 15 px
  int margin_pixels = 5;  // patch pixels around the box at least: what an outline is told by
  int limit = 128;        // patch pixels a side
  std::int64_t budget =
      131072;  // bytes of all patches of one image pair: a message that survives default socket buffers
};

// Patch pixel (i, j) averages the image's columns x + i * scale .. x + (i + 1) * scale - 1, rows likewise.
struct Patch {
  int x = 0;
  int y = 0;
  int scale = 0;  // 0: no patch
  int width = 0;
  int height = 0;
  std::vector<std::uint8_t> bgr;
  std::vector<std::uint8_t> mask;  // a bit a patch pixel, rows padded to bytes, lowest bit first: half or more is mark
  std::vector<std::uint32_t> column_sums;  // room for averaging
  std::vector<std::uint32_t> mark_counts;  // likewise
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

// Cuts the patch and averages it, rounding to nearest. `patch` keeps its memory.
void cut_patch(const ImageView& image, const Region& mark, const PatchFrame& frame, Patch& patch);

}  // namespace markservo::mark_detector
