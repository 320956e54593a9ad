#include "services/target-locator/image/mark_masks.hpp"

#include <cstddef>
#include <cstdint>

namespace markservo::target_locator {
namespace {

constexpr int kEdgeMargin = 2;  // patch px on either side of the outline that belong to neither class
constexpr int kRingReach = 5;   // patch px, how far the ring of surroundings reaches

}  // namespace

void unpack_mask(const Patch& patch, Mask& mask) {
  mask.reset(patch.width, patch.height);
  const int bytes = (patch.width + 7) / 8;
  const int spare = patch.width % Mask::kWordBits;
  for (int y = 0; y < patch.height; ++y) {
    std::uint64_t* words = mask.row(y);
    const std::uint8_t* bits = patch.mask + static_cast<std::ptrdiff_t>(y) * bytes;
    std::uint8_t any = 0;
    for (int i = 0; i < bytes; ++i) {
      words[i / 8] |= static_cast<std::uint64_t>(bits[i]) << (i % 8 * 8);
      any |= bits[i];
    }
    if (any == 0) mask.declare_empty(y);
    if (spare > 0) words[mask.words_per_row() - 1] &= imaging::low_bits(spare);
  }
}

Mask unpack_mask(const Patch& patch) {
  Mask mask;
  unpack_mask(patch, mask);
  return mask;
}

void prepare_masks(const Patch& patch, MarkMasks& masks) {
  unpack_mask(patch, masks.mask);
  imaging::erode(masks.mask, kEdgeMargin, masks.inner);
}

void make_ring(MarkMasks& masks) {
  imaging::dilate(masks.mask, kEdgeMargin, masks.ring);
  imaging::dilate(masks.mask, kRingReach, masks.reach);
  imaging::subtract(masks.reach, masks.ring, masks.ring);
}

}  // namespace markservo::target_locator
