#include "services/mark-detector/region.hpp"

#include <algorithm>

namespace markservo::mark_detector {
Region make_region(const std::vector<PixelRun>& runs, int margin, int image_width, int image_height) {
  Region region;
  if (runs.empty()) return region;
  const Shape shape = shape_of(runs);
  region.x = std::max(0, shape.x - margin);
  region.y = std::max(0, shape.y - margin);
  region.width = std::min(image_width, shape.x + shape.width + margin) - region.x;
  region.height = std::min(image_height, shape.y + shape.height + margin) - region.y;
  region.inside = BitMask(region.width, region.height);
  for (const PixelRun& run : runs) {
    region.inside.set_run(run.v - region.y, run.begin - region.x, run.end - region.x);
  }
  return region;
}

Depths depths(const Region& region, int band) {
  const BitMask near_mark = dilate(region.inside, band);
  const BitMask near_rest = dilate(complement(region.inside), band);
  Depths result{complement(near_rest), BitMask(region.width, region.height), complement(near_mark)};
  for (int j = 0; j < region.height; ++j) {
    const uint64_t* mark = near_mark.row(j);
    const uint64_t* rest = near_rest.row(j);
    uint64_t* both = result.band.row(j);
    for (int i = 0; i < near_mark.words_per_row(); ++i) both[i] = mark[i] & rest[i];
  }
  return result;
}

}  // namespace markservo::mark_detector
