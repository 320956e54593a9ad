#include "services/mark-detector/outline.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "services/mark-detector/outline_kernel.hpp"

namespace markservo::mark_detector {
namespace {

// What is summed of the columns around a pixel: as ColumnSums has it.
using ColourSums = std::array<int, ColumnSums::kPlanes>;

// Column sums over the rows around one row, moved down as the row moves: memory of one row whatever the mark's size.
class LocalColours {
 public:
  LocalColours(const ImageView& image, const Region& region, const Depths& depths, int reach)
      : image_(image), region_(region), depths_(depths), reach_(reach), columns_(region.width) {
    for (int j = 0; j < std::min(reach_, region_.height); ++j) add_row(j, 1);
  }

  // Rows must be visited in order, from 0.
  void move_to(int j) {
    if (j + reach_ < region_.height) add_row(j + reach_, 1);
    if (j - reach_ - 1 >= 0) add_row(j - reach_ - 1, -1);
    at_ = kNowhere;
  }

  // Around column i; least work for columns in order.
  const ColourSums& around(int i) {
    if (at_ != kNowhere && at_ < i && i - at_ <= reach_) {
      while (at_ < i) {
        ++at_;
        if (at_ + reach_ < region_.width) add_column(at_ + reach_, 1);
        if (at_ - reach_ - 1 >= 0) add_column(at_ - reach_ - 1, -1);
      }
      return sums_;
    }
    sums_ = ColourSums{};
    const int end = std::min(region_.width, i + reach_ + 1);
    for (int column = std::max(0, i - reach_); column < end; ++column) add_column(column, 1);
    at_ = i;
    return sums_;
  }

 private:
  static constexpr int kNowhere = -1;

  void add_row(int j, int sign) {
    columns_.add(image_.pixel(region_.x, region_.y + j), depths_.inside.row(j), depths_.outside.row(j), sign);
  }
  void add_column(int column, int sign) {
    for (std::size_t k = 0; k < sums_.size(); ++k) {
      sums_[k] += sign * columns_.at(static_cast<ColumnSums::Plane>(k), column);
    }
  }

  const ImageView& image_;
  const Region& region_;
  const Depths& depths_;
  int reach_;
  ColumnSums columns_;
  ColourSums sums_{};
  int at_ = kNowhere;
};

// Coverage of pixel p, or `classified` where it cannot be told. With n and s the counts and sums of both classes, what
// is scaled by n_mark n_rest, and what is from the background by n_rest, needs no division.
double coverage(const ColourSums& sums, const uint8_t* p, double classified, const OutlineParameters& parameters) {
  const double n_mark = sums[ColumnSums::kMarkCount];
  const double n_rest = sums[ColumnSums::kRestCount];
  if (n_mark == 0.0 || n_rest == 0.0) return classified;
  double along = 0.0;
  double contrast_2 = 0.0;
  double distance_2 = 0.0;
  for (std::size_t c = 0; c < 3; ++c) {
    const double background = sums[ColumnSums::kRestB + c];
    const double step = sums[ColumnSums::kMarkB + c] * n_rest - background * n_mark;
    const double from_background = p[c] * n_rest - background;
    along += from_background * step;
    contrast_2 += step * step;
    distance_2 += from_background * from_background;
  }
  const double least = parameters.contrast_min * n_mark * n_rest;
  if (contrast_2 < least * least) return classified;
  const double share = along / contrast_2;
  const double beside = parameters.beside_max / n_mark;
  if (distance_2 - along * share > beside * beside * contrast_2) return classified;
  return std::clamp(share * n_mark, 0.0, 1.0);
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
    if (weight >= 0.5) widen(i, i + 1, j);
  }
  // Columns [begin, end) of row j, wholly covered.
  void add_run(int begin, int end, int j) {
    const double n = end - begin;
    const double u = 0.5 * n * (begin + end - 1);
    const auto squares = [](double m) { return (m - 1.0) * m * (2.0 * m - 1.0) / 6.0; };  // 0 + 1 + 4 + ... + (m - 1)^2
    area_ += n;
    sum_u_ += u;
    sum_v_ += n * j;
    sum_uu_ += squares(end) - squares(begin);
    sum_uv_ += u * j;
    sum_vv_ += n * j * j;
    widen(begin, end, j);
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
  void widen(int begin, int end, int j) {
    left_ = std::min(left_, begin);
    right_ = std::max(right_, end);
    top_ = std::min(top_, j);
    bottom_ = std::max(bottom_, j + 1);
  }

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
  const Depths depth = depths(region, parameters.band);
  LocalColours colours(image, region, depth, parameters.reach);
  WeightedShape weighted;
  for (int j = 0; j < region.height; ++j) {
    colours.move_to(j);
    const uint64_t* band = depth.band.row(j);
    for (int word = 0; word < depth.band.words_per_row(); ++word) {
      for (uint64_t bits = band[word]; bits != 0; bits &= bits - 1) {
        const int i = word * BitMask::kWordBits + __builtin_ctzll(bits);
        const double classified = region.inside.test(i, j) ? 1.0 : 0.0;
        const double alpha =
            coverage(colours.around(i), image.pixel(region.x + i, region.y + j), classified, parameters);
        region.inside.set(i, j, alpha >= 0.5);
        weighted.add(i, j, alpha);
      }
    }
    for (int begin = depth.inside.next(j, 0, true); begin < region.width;) {
      const int end = depth.inside.next(j, begin, false);
      weighted.add_run(begin, end, j);
      begin = depth.inside.next(j, end, true);
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
