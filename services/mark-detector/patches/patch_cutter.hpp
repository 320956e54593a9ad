#pragma once

// Cuts patches out of an image.

#include <cstdint>
#include <vector>

#include "services/mark-detector/blobs/region.hpp"
#include "services/mark-detector/image_view.hpp"
#include "services/mark-detector/patches/patch.hpp"
#include "services/mark-detector/patches/patch_plan.hpp"

namespace markservo::mark_detector {

// Keeps its memory from patch to patch.
class PatchCutter {
 public:
  // Cuts the patch and averages it, rounding to nearest. `patch` keeps its memory.
  void cut(const ImageView& image, const Region& mark, const PatchFrame& frame, Patch& patch);

 private:
  void average(const ImageView& image, const Region& mark, Patch& patch);

  std::vector<std::uint32_t> column_sums_;
  std::vector<std::uint32_t> mark_counts_;
};

}  // namespace markservo::mark_detector
