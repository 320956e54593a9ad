#include "services/mark-detector/blobs/region.hpp"

#include <algorithm>

namespace markservo::mark_detector {

void make_region(RunSpan runs, const Shape& shape, int margin, int image_width, int image_height, Region& region) {
  region.x = runs.empty() ? 0 : std::max(0, shape.x - margin);
  region.y = runs.empty() ? 0 : std::max(0, shape.y - margin);
  region.width = runs.empty() ? 0 : std::min(image_width, shape.x + shape.width + margin) - region.x;
  region.height = runs.empty() ? 0 : std::min(image_height, shape.y + shape.height + margin) - region.y;
  region.inside.reset(region.width, region.height);
  for (const PixelRun& run : runs) {
    region.inside.set_run(run.v - region.y, run.begin - region.x, run.end - region.x);
  }
}

}  // namespace markservo::mark_detector
