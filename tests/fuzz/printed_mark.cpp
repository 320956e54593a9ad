#include "tests/fuzz/printed_mark.hpp"

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/fuzz/numbers.hpp"

namespace markservo::fuzz {
namespace {

constexpr int kUsualSide = 48;    // patch px
constexpr int kMargin = 8;        // patch px around the mark
constexpr int kMaxSide = 80;      // patch px
constexpr double kLeftX = 400.0;  // px of the image, where the left patch begins
constexpr double kTopY = 200.0;

// What the print looks like and how its plane lies.
struct Print {
  int width = kUsualSide;
  int height = kUsualSide;
  double disparity = 0.0;  // px at the left patch's left edge
  double along_u = 0.0;    // px per px
  double along_v = 0.0;
  int cell = 3;       // px of the print's grain
  int contrast = 0;   // grey levels either way
  int noise = 0;      // grey levels either way
  unsigned seed = 0;  // of the print
};

Print take_print(FuzzedDataProvider& data) {
  Print print;
  if (data.ConsumeBool()) {
    print.width = data.ConsumeIntegralInRange(1, kMaxSide);
    print.height = data.ConsumeIntegralInRange(1, kMaxSide);
  }
  print.disparity = number(data, 200.0, -20.0, 400.0);
  if (!std::isfinite(print.disparity)) print.disparity = 0.0;
  print.along_u = data.ConsumeIntegralInRange(0, 40) * 0.01;
  print.along_v = data.ConsumeIntegralInRange(0, 40) * 0.01;
  print.cell = 3 + data.ConsumeIntegralInRange(0, 9);
  print.contrast = 60 - data.ConsumeIntegralInRange(0, 60);
  print.noise = data.ConsumeIntegralInRange(0, 40);
  print.seed = data.ConsumeIntegral<std::uint8_t>();
  return print;
}

// -1..1 at a corner of the print's grain.
double grain(unsigned seed, int column, int row) {
  std::minstd_rand random(seed * 7919U + static_cast<unsigned>(column + 4096) * 131U +
                          static_cast<unsigned>(row + 4096) * 8191U + 1U);
  random.discard(3);
  return static_cast<double>(random() % 2001U) / 1000.0 - 1.0;
}

double brightness(const Print& print, double u, double v) {
  const double x = std::clamp(u / print.cell, -2000.0, 2000.0);
  const double y = std::clamp(v / print.cell, -2000.0, 2000.0);
  const int column = static_cast<int>(std::floor(x));
  const int row = static_cast<int>(std::floor(y));
  const double fx = x - column;
  const double fy = y - row;
  const double above = (1.0 - fx) * grain(print.seed, column, row) + fx * grain(print.seed, column + 1, row);
  const double below = (1.0 - fx) * grain(print.seed, column, row + 1) + fx * grain(print.seed, column + 1, row + 1);
  return print.contrast * ((1.0 - fy) * above + fy * below);
}

enum class MaskKind { kMark, kHidden, kEmpty, kFull, kBytes };

// `shift`: how far to the left the right image shows what the left one does, beyond the disparity at the patch's edge.
PrintedPatch draw(FuzzedDataProvider& data, const Print& print, bool right) {
  PrintedPatch patch;
  patch.width = print.width;
  patch.height = print.height;
  const auto kind =
      static_cast<MaskKind>(data.ConsumeIntegralInRange(0, 7) < 4 ? 0 : data.ConsumeIntegralInRange(0, 4));
  const std::size_t mask_stride = (static_cast<std::size_t>(patch.width) + 7) / 8;
  patch.bgr.resize(static_cast<std::size_t>(patch.width) * static_cast<std::size_t>(patch.height) * 3);
  patch.mask.resize(mask_stride * static_cast<std::size_t>(patch.height));
  std::minstd_rand noise(right ? 2U : 1U);
  const double along_u = right ? print.along_u : 0.0;
  const double along_v = right ? print.along_v : 0.0;
  const auto inside = [&](int i, int j) {
    const bool mark = i >= kMargin && j >= kMargin && i < patch.width - kMargin && j < patch.height - kMargin;
    if (kind == MaskKind::kHidden) return mark && i < patch.width / 2;
    return kind == MaskKind::kFull || (kind == MaskKind::kMark && mark);
  };
  std::size_t at = 0;
  for (int j = 0; j < patch.height; ++j) {
    for (int i = 0; i < patch.width; ++i) {
      const double light = brightness(print, (i + along_v * j) / (1.0 - along_u), j);
      const bool mark = i >= kMargin && j >= kMargin && i < patch.width - kMargin && j < patch.height - kMargin;
      const int base[] = {mark ? 40 : 120, mark ? 35 : 120, mark ? 160 : 120};
      for (const int level : base) {
        const int off =
            print.noise == 0 ? 0 : static_cast<int>(noise() % (2U * static_cast<unsigned>(print.noise) + 1U));
        patch.bgr[at++] =
            static_cast<std::uint8_t>(std::clamp(level + static_cast<int>(light) + off - print.noise, 0, 255));
      }
      if (inside(i, j)) {
        std::uint8_t& byte = patch.mask[static_cast<std::size_t>(j) * mask_stride + static_cast<std::size_t>(i) / 8];
        byte = static_cast<std::uint8_t>(byte | (1U << (i % 8)));
      }
    }
  }
  const auto overwrite = [&data](std::vector<std::uint8_t>& bytes, std::size_t most) {
    const std::vector<std::uint8_t> raw =
        data.ConsumeBytes<std::uint8_t>(data.ConsumeIntegralInRange<std::size_t>(0, most));
    std::copy_n(raw.begin(), std::min(raw.size(), bytes.size()), bytes.begin());
  };
  if (kind == MaskKind::kBytes) overwrite(patch.mask, 512);
  if (data.ConsumeIntegralInRange(0, 7) == 7) overwrite(patch.bgr, 1024);
  return patch;
}

// A 32-bit integer or any double.
double place(FuzzedDataProvider& data, bool whole_numbers, double usual) {
  if (!whole_numbers) return number(data, usual, -1e3, 1e3);
  switch (data.ConsumeIntegralInRange(0, 7)) {
    case 6:
      return usual + data.ConsumeIntegralInRange(-20, 20);
    case 7:
      return data.ConsumeIntegral<std::int32_t>();
    default:
      return usual;
  }
}

target_locator::View view_of(FuzzedDataProvider& data, bool whole_numbers, const PrintedPatch& patch, double x) {
  target_locator::View view;
  view.seen = data.ConsumeIntegralInRange(0, 15) < 15;
  view.clipped = data.ConsumeIntegralInRange(0, 15) == 15;
  double scale = 1.0;
  if (data.ConsumeIntegralInRange(0, 7) == 7) scale = data.ConsumeIntegralInRange(1, 8);
  if (data.ConsumeIntegralInRange(0, 15) == 15) scale = std::max(1.0, place(data, whole_numbers, 1.0));
  view.patch.frame = {place(data, whole_numbers, std::round(x)), place(data, whole_numbers, kTopY), scale};
  view.x = place(data, whole_numbers, std::round(x + kMargin * scale));
  view.y = place(data, whole_numbers, kTopY + kMargin * scale);
  view.width = place(data, whole_numbers, std::max(1.0, std::round((patch.width - 2 * kMargin) * scale)));
  view.height = place(data, whole_numbers, std::max(1.0, std::round((patch.height - 2 * kMargin) * scale)));
  view.patch.width = patch.width;
  view.patch.height = patch.height;
  view.patch.bgr = patch.bgr.data();
  view.patch.mask = patch.mask.data();
  return view;
}

}  // namespace

void print_mark(FuzzedDataProvider& data, bool whole_numbers, PrintedMark& mark) {
  const Print print = take_print(data);
  mark.left = draw(data, print, false);
  mark.right = draw(data, print, true);
  mark.observation.left = view_of(data, whole_numbers, mark.left, kLeftX);
  mark.observation.right = view_of(data, whole_numbers, mark.right, kLeftX - print.disparity);
  mark.observation.surface =
      data.ConsumeIntegralInRange(0, 3) == 3 ? target_locator::Surface::kFree : target_locator::Surface::kPlane;
  mark.observation.size = number(data, 0.0, 0.0, 0.1);
  if (data.ConsumeIntegralInRange(0, 3) == 3) mark.observation.surface = target_locator::Surface::kBall;
  const int outline = data.ConsumeIntegralInRange(0, 2);
  if (outline == 1) mark.observation.outline = target_locator::Outline::kDisc;
  if (outline == 2) mark.observation.outline = target_locator::Outline::kOther;
}

}  // namespace markservo::fuzz
