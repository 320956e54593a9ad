#include "services/mark-detector/outline.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace markservo::mark_detector {
namespace {

// Sums of the pixels that are surely the mark, then of those that surely are not.
struct ColourSums {
  enum Index { kMarkCount, kMarkB, kMarkG, kMarkR, kRestCount, kRestB, kRestG, kRestR, kSize };
  std::array<int64_t, kSize> sum{};

  void add(Depth depth, const uint8_t* p, int sign) {
    if (depth != Depth::kInside && depth != Depth::kOutside) return;
    const std::size_t first = depth == Depth::kInside ? kMarkCount : kRestCount;
    sum[first] += sign;
    for (std::size_t c = 0; c < 3; ++c) sum[first + 1 + c] += static_cast<int64_t>(sign) * p[c];
  }
  void add(const ColourSums& other, int sign) {
    for (std::size_t i = 0; i < sum.size(); ++i) sum[i] += sign * other.sum[i];
  }
};

// Column sums over the rows around one row, moved down as the row moves: memory of one row whatever the mark's size.
class LocalColours {
 public:
  LocalColours(const ImageView& image, const Region& region, const std::vector<Depth>& depth, int reach)
      : image_(image),
        region_(region),
        depth_(depth),
        reach_(reach),
        columns_(static_cast<std::size_t>(region.width)),
        prefix_(columns_.size() + 1) {
    for (int j = 0; j < std::min(reach_, region_.height); ++j) add_row(j, 1);
  }

  // Rows must be visited in order, from 0.
  void move_to(int j) {
    if (j + reach_ < region_.height) add_row(j + reach_, 1);
    if (j - reach_ - 1 >= 0) add_row(j - reach_ - 1, -1);
    for (std::size_t i = 0; i < columns_.size(); ++i) {
      prefix_[i + 1] = prefix_[i];
      prefix_[i + 1].add(columns_[i], 1);
    }
  }

  ColourSums around(int i) const {
    const auto begin = static_cast<std::size_t>(std::max(0, i - reach_));
    const auto end = static_cast<std::size_t>(std::min(region_.width, i + reach_ + 1));
    ColourSums sums = prefix_[end];
    sums.add(prefix_[begin], -1);
    return sums;
  }

 private:
  void add_row(int j, int sign) {
    const uint8_t* p = image_.pixel(region_.x, region_.y + j);
    const Depth* depth = &depth_[region_.index(0, j)];
    for (std::size_t i = 0; i < columns_.size(); ++i, p += 3) columns_[i].add(depth[i], p, sign);
  }

  const ImageView& image_;
  const Region& region_;
  const std::vector<Depth>& depth_;
  int reach_;
  std::vector<ColourSums> columns_;
  std::vector<ColourSums> prefix_;
};

// Coverage of pixel p, or `classified` where it cannot be told.
double coverage(const ColourSums& sums, const uint8_t* p, double classified, const OutlineParameters& parameters) {
  const auto value = [&sums](std::size_t i) { return static_cast<double>(sums.sum[i]); };
  const double n_mark = value(ColourSums::kMarkCount);
  const double n_rest = value(ColourSums::kRestCount);
  if (n_mark == 0.0 || n_rest == 0.0) return classified;
  double along = 0.0;
  double contrast_2 = 0.0;
  double distance_2 = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double background = value(ColourSums::kRestB + c) / n_rest;
    const double step = value(ColourSums::kMarkB + c) / n_mark - background;
    const double from_background = p[c] - background;
    along += from_background * step;
    contrast_2 += step * step;
    distance_2 += from_background * from_background;
  }
  if (contrast_2 < parameters.contrast_min * parameters.contrast_min) return classified;
  const double beside_2 = distance_2 - along * along / contrast_2;
  if (beside_2 > parameters.beside_max * parameters.beside_max * contrast_2) return classified;
  return std::clamp(along / contrast_2, 0.0, 1.0);
}

// Weighted sums from the region's corner.
class WeightedShape {
 public:
  void add(int i, int j, double weight) {
    area_ += weight;
    sum_u_ += weight * i;
    sum_v_ += weight * j;
    sum_uu_ += weight * i * i;
    sum_uv_ += weight * i * j;
    sum_vv_ += weight * j * j;
    if (weight < 0.5) return;
    left_ = std::min(left_, i);
    right_ = std::max(right_, i + 1);
    top_ = std::min(top_, j);
    bottom_ = std::max(bottom_, j + 1);
  }

  // At least one pixel must have been added with a weight of a half or more.
  Shape shape(const Region& region) const {
    Shape shape;
    const double u = sum_u_ / area_;
    const double v = sum_v_ / area_;
    shape.x = region.x + left_;
    shape.y = region.y + top_;
    shape.width = right_ - left_;
    shape.height = bottom_ - top_;
    shape.area = area_;
    shape.u = region.x + u;
    shape.v = region.y + v;
    shape.m_uu = sum_uu_ / area_ - u * u;
    shape.m_uv = sum_uv_ / area_ - u * v;
    shape.m_vv = sum_vv_ / area_ - v * v;
    return shape;
  }
  bool empty() const { return right_ == 0; }

 private:
  double area_ = 0.0;
  double sum_u_ = 0.0;
  double sum_v_ = 0.0;
  double sum_uu_ = 0.0;
  double sum_uv_ = 0.0;
  double sum_vv_ = 0.0;
  int left_ = std::numeric_limits<int>::max();
  int right_ = 0;
  int top_ = std::numeric_limits<int>::max();
  int bottom_ = 0;
};

}  // namespace

OutlinedMark outline(const ImageView& image, const std::vector<PixelRun>& runs, const OutlineParameters& parameters) {
  OutlinedMark mark;
  const int margin = parameters.band + parameters.reach;  // background enough for the outermost blended pixel
  mark.region = make_region(runs, margin, image.width, image.height);
  Region& region = mark.region;
  const std::vector<Depth> depth = depths(region, parameters.band);
  LocalColours colours(image, region, depth, parameters.reach);
  WeightedShape weighted;
  for (int j = 0; j < region.height; ++j) {
    colours.move_to(j);
    for (int i = 0; i < region.width; ++i) {
      const std::size_t k = region.index(i, j);
      if (depth[k] == Depth::kOutside) continue;
      double alpha = region.inside[k];
      if (depth[k] != Depth::kInside) {
        alpha = coverage(colours.around(i), image.pixel(region.x + i, region.y + j), alpha, parameters);
      }
      region.inside[k] = alpha >= 0.5 ? 1 : 0;
      weighted.add(i, j, alpha);
    }
  }
  if (weighted.empty()) return hard_outline(runs, image.width, image.height);
  mark.shape = weighted.shape(region);
  return mark;
}

OutlinedMark hard_outline(const std::vector<PixelRun>& runs, int image_width, int image_height) {
  return {shape_of(runs), make_region(runs, 1, image_width, image_height)};
}

}  // namespace markservo::mark_detector
