#include "services/mark-detector/region.hpp"

#include <algorithm>

namespace markservo::mark_detector {
namespace {

// For each pixel, whether one within `reach` along the row or column has `wanted`.
void spread(const uint8_t* in, uint8_t* out, int n, std::size_t step, int reach, uint8_t wanted) {
  int last = -reach - 1;
  const auto at = [step](int i) { return static_cast<std::size_t>(i) * step; };
  for (int i = 0; i < n; ++i) out[at(i)] = 0;
  for (int i = 0; i < n; ++i) {
    if (in[at(i)] == wanted) last = i;
    if (i - last <= reach) out[at(i)] = 1;
  }
  last = n + reach + 1;
  for (int i = n - 1; i >= 0; --i) {
    if (in[at(i)] == wanted) last = i;
    if (last - i <= reach) out[at(i)] = 1;
  }
}

// Where a pixel with `wanted` is within a square of half side `reach`.
std::vector<uint8_t> near(const Region& region, int reach, uint8_t wanted) {
  std::vector<uint8_t> rows(region.inside.size());
  std::vector<uint8_t> both(region.inside.size());
  for (int j = 0; j < region.height; ++j) {
    spread(&region.inside[region.index(0, j)], &rows[region.index(0, j)], region.width, 1, reach, wanted);
  }
  const auto step = static_cast<std::size_t>(region.width);
  for (int i = 0; i < region.width; ++i)
    spread(&rows[region.index(i, 0)], &both[region.index(i, 0)], region.height, step, reach, 1);
  return both;
}

}  // namespace

Region make_region(const std::vector<PixelRun>& runs, int margin, int image_width, int image_height) {
  Region region;
  if (runs.empty()) return region;
  const Shape shape = shape_of(runs);
  region.x = std::max(0, shape.x - margin);
  region.y = std::max(0, shape.y - margin);
  region.width = std::min(image_width, shape.x + shape.width + margin) - region.x;
  region.height = std::min(image_height, shape.y + shape.height + margin) - region.y;
  region.inside.assign(static_cast<std::size_t>(region.width) * static_cast<std::size_t>(region.height), 0);
  for (const PixelRun& run : runs) {
    const auto begin =
        region.inside.begin() + static_cast<std::ptrdiff_t>(region.index(run.begin - region.x, run.v - region.y));
    std::fill_n(begin, run.end - run.begin, uint8_t{1});
  }
  return region;
}

std::vector<Depth> depths(const Region& region, int band) {
  std::vector<Depth> result(region.inside.size());
  if (region.inside.empty()) return result;
  const std::vector<uint8_t> near_mark = near(region, band, 1);
  const std::vector<uint8_t> near_rest = near(region, band, 0);
  for (std::size_t i = 0; i < result.size(); ++i) {
    if (region.inside[i] != 0) {
      result[i] = near_rest[i] != 0 ? Depth::kInnerBand : Depth::kInside;
    } else {
      result[i] = near_mark[i] != 0 ? Depth::kOuterBand : Depth::kOutside;
    }
  }
  return result;
}

}  // namespace markservo::mark_detector
