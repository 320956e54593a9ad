#include "services/mark-detector/learning/mark_share.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace markservo::mark_detector {
namespace {

// Chromaticity of -1 to 1 in steps of three times what noise of 3 levels does to a mark of usual light; brightness in
// half octaves from 8 levels on, for shade scales it.
constexpr int kChromaticityCells = 40;
constexpr int kBrightnessCells = 11;
constexpr double kDarkest = 8.0;  // level
constexpr double kCellsPerOctave = 2.0;
constexpr double kLeastPixels = 0.5;  // taken for seen in every cell: what was never seen is not impossible

constexpr std::size_t kCells = std::size_t{kChromaticityCells} * kChromaticityCells * kBrightnessCells;
constexpr std::size_t kAlongX = 1;
constexpr std::size_t kAlongY = kChromaticityCells;
constexpr std::size_t kAlongBrightness = std::size_t{kChromaticityCells} * kChromaticityCells;

std::size_t cell_along(double place, int cells) {
  return static_cast<std::size_t>(std::clamp(static_cast<int>(std::floor(place)), 0, cells - 1));
}

std::size_t cell_of(const LearningPixel& pixel) {
  const double half = 0.5 * kChromaticityCells;
  const double octaves = std::log2(std::max(1.0, pixel.level / kDarkest));
  return cell_along(half * (pixel.x + 1.0), kChromaticityCells) * kAlongX +
         cell_along(half * (pixel.y + 1.0), kChromaticityCells) * kAlongY +
         cell_along(kCellsPerOctave * octaves, kBrightnessCells) * kAlongBrightness;
}

// Colours' distribution, smoothed over the neighbouring cells.
class Distribution {
 public:
  Distribution() : density_(kCells), room_(kCells) {}

  void clear() {
    std::fill(density_.begin(), density_.end(), 0.0);
    total_ = 0.0;
  }
  void add(std::size_t cell, double weight) {
    density_[cell] += weight;
    total_ += weight;
  }
  void smooth() {
    smooth_along(kAlongX, kChromaticityCells);
    smooth_along(kAlongY, kChromaticityCells);
    smooth_along(kAlongBrightness, kBrightnessCells);
  }
  double total() const { return total_; }
  double at(std::size_t cell) const { return (density_[cell] + kLeastPixels) / (total_ + kLeastPixels); }

 private:
  // A quarter to either neighbour; at an end it stays.
  void smooth_along(std::size_t stride, int cells) {
    std::fill(room_.begin(), room_.end(), 0.0);
    for (std::size_t i = 0; i < kCells; ++i) {
      if (density_[i] == 0.0) continue;
      const std::size_t place = i / stride % static_cast<std::size_t>(cells);
      room_[i] += 0.5 * density_[i];
      room_[place == 0 ? i : i - stride] += 0.25 * density_[i];
      room_[place + 1 == static_cast<std::size_t>(cells) ? i : i + stride] += 0.25 * density_[i];
    }
    density_.swap(room_);
  }

  std::vector<double> density_;
  std::vector<double> room_;
  double total_ = 0.0;
};

double share_by_place(const LearningPixel& pixel, const MarkShareParameters& parameters) {
  if (!pixel.in_box) return parameters.share_outside;
  return parameters.share_at_edge + (parameters.share_in_middle - parameters.share_at_edge) * pixel.middle;
}

}  // namespace

void set_mark_shares(std::vector<LearningPixel>& pixels, const MarkShareParameters& parameters) {
  std::vector<std::size_t> cells;
  cells.reserve(pixels.size());
  bool surrounded = false;
  for (LearningPixel& pixel : pixels) {
    cells.push_back(cell_of(pixel));
    pixel.mark_share = share_by_place(pixel, parameters);
    surrounded = surrounded || !pixel.in_box;
  }
  if (!surrounded) return;
  Distribution mark;
  Distribution background;
  for (int round = 0; round < parameters.rounds; ++round) {
    mark.clear();
    background.clear();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      if (pixels[i].in_box) {
        mark.add(cells[i], pixels[i].mark_share);
      } else {
        background.add(cells[i], 1.0 - pixels[i].mark_share);
      }
    }
    mark.smooth();
    background.smooth();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const double place = share_by_place(pixels[i], parameters);
      const double by_mark = place * mark.at(cells[i]);
      pixels[i].mark_share = by_mark / (by_mark + (1.0 - place) * background.at(cells[i]));
    }
  }
}

}  // namespace markservo::mark_detector
