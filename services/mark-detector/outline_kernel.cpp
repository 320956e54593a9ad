#include "services/mark-detector/outline_kernel.hpp"

#include <algorithm>
#include <cstddef>

#include "services/mark-detector/pixel_block.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "services/mark-detector/outline_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace markservo::mark_detector::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int kBlock = BitMask::kWordBits;

// One block of columns; `sums` are the planes, `stride` apart.
void AddBlock(const uint8_t* bgr, uint64_t mark, uint64_t rest, int sign, int16_t* sums, std::size_t stride) {
  const hn::CappedTag<int16_t, kBlock> d;
  const hn::Rebind<uint8_t, decltype(d)> bytes;
  const int n = static_cast<int>(hn::Lanes(d));
  const auto flip = hn::Set(d, static_cast<int16_t>(sign < 0 ? -1 : 0));
  for (int u = 0; u < kBlock; u += n) {
    const uint64_t mark_bits = mark >> u;
    const uint64_t rest_bits = rest >> u;
    auto b8 = hn::Zero(bytes);
    auto g8 = hn::Zero(bytes);
    auto r8 = hn::Zero(bytes);
    hn::LoadInterleaved3(bytes, bgr + std::ptrdiff_t{3} * u, b8, g8, r8);
    const auto one = hn::Set(d, 1);
    const auto b = hn::PromoteTo(d, b8);
    const auto g = hn::PromoteTo(d, g8);
    const auto r = hn::PromoteTo(d, r8);
    const auto add = [&](uint64_t bits, int first) {
      const auto chosen = hn::LoadMaskBits(d, reinterpret_cast<const uint8_t*>(&bits));
      int plane = first;
      for (const auto& value : {one, b, g, r}) {
        int16_t* out = sums + static_cast<std::size_t>(plane++) * stride + u;
        // Minus x is (x ^ -1) - -1.
        const auto signed_value = hn::Sub(hn::Xor(hn::IfThenElseZero(chosen, value), flip), flip);
        hn::StoreU(hn::Add(hn::LoadU(d, out), signed_value), d, out);
      }
    };
    add(mark_bits, ColumnSums::kMarkCount);
    add(rest_bits, ColumnSums::kRestCount);
  }
}

}  // namespace markservo::mark_detector::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace markservo::mark_detector {

HWY_EXPORT(AddBlock);

namespace {

constexpr int kBlock = BitMask::kWordBits;

std::size_t padded(int width) {
  return static_cast<std::size_t>((width + kBlock - 1) / kBlock) * kBlock;
}

}  // namespace

ColumnSums::ColumnSums(int width) : width_(width), stride_(padded(width)), sums_(kPlanes * stride_, 0) {}

void ColumnSums::add(const uint8_t* bgr, const uint64_t* mark, const uint64_t* rest, int sign) {
  const auto block = HWY_DYNAMIC_DISPATCH(AddBlock);
  for (int u = 0; u < width_; u += kBlock) {
    const uint8_t* pixels = bgr + 3 * static_cast<std::ptrdiff_t>(u);
    const int count = std::min(kBlock, width_ - u);
    PixelBlock rest_of_row;
    if (count < kBlock) pixels = pad_block(pixels, count, rest_of_row);
    block(pixels, mark[u / kBlock], rest[u / kBlock], sign, sums_.data() + u, stride_);
  }
}

}  // namespace markservo::mark_detector
#endif  // HWY_ONCE
