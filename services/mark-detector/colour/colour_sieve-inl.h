// Leaves out blocks of pixels, most of an image, that are too grey for every rule. Per target: included by the kernel,
// after hwy/highway.h.

#if defined(MARKSERVO_COLOUR_SIEVE_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MARKSERVO_COLOUR_SIEVE_INL_H
#undef MARKSERVO_COLOUR_SIEVE_INL_H
#else
#define MARKSERVO_COLOUR_SIEVE_INL_H
#endif

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "services/mark-detector/colour/frame_rule.hpp"
#include "services/mark-detector/colour/pixel_block.hpp"

HWY_BEFORE_NAMESPACE();
namespace markservo::mark_detector::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// What the easiest of the rules asks for, in bytes and never more than that.
struct Sieve {
  std::uint8_t chroma = 255;
  std::uint8_t halves = 0;  // all bits set if the least saturation has that share in it, of value
  std::uint8_t quarters = 0;
  std::uint8_t eighths = 0;
};

HWY_INLINE Sieve make_sieve(const FrameRule* rules, int num_rules) {
  Sieve sieve;
  int least_saturation = ColourRule::kSaturationScale;
  for (int k = 0; k < num_rules; ++k) {
    sieve.chroma = static_cast<std::uint8_t>(std::min<int>(sieve.chroma, rules[k].rule.chroma_min));
    least_saturation = std::min<int>(least_saturation, rules[k].rule.saturation_min);
  }
  const int eighths = std::min(7, 8 * least_saturation / ColourRule::kSaturationScale);
  const auto share = [eighths](int bit) { return static_cast<std::uint8_t>((eighths & bit) != 0 ? 255 : 0); };
  sieve.halves = share(4);
  sieve.quarters = share(2);
  sieve.eighths = share(1);
  return sieve;
}

#if HWY_TARGET == HWY_SCALAR
// Whether the pixels that begin at each of a block's bytes get through the sieve. Over all bytes, as if a pixel began
// at each, so that the compiler can use what vectors there are; the number of bytes is fixed for the same reason.
template <int kBytes>
HWY_INLINE void sift_bytes(const std::uint8_t* bgr, const Sieve& sieve, std::uint8_t* through) {
  for (int i = 0; i < kBytes; ++i) {
    const std::uint8_t value = std::max(bgr[i], std::max(bgr[i + 1], bgr[i + 2]));
    const std::uint8_t least = std::min(bgr[i], std::min(bgr[i + 1], bgr[i + 2]));
    const auto chroma = static_cast<std::uint8_t>(value - least);
    const auto saturated = static_cast<std::uint8_t>(((value >> 1) & sieve.halves) + ((value >> 2) & sieve.quarters) +
                                                     ((value >> 3) & sieve.eighths));
    through[i] = chroma >= std::max(saturated, sieve.chroma) ? 1 : 0;
  }
}

// Which of a block's pixels get through the sieve; `more`: others follow in memory.
HWY_INLINE std::uint64_t sift(const std::uint8_t* bgr, bool more, const Sieve& sieve) {
  constexpr int kBytes = 3 * kBlock;
  std::uint8_t through[kBytes] = {};
  if (more) {
    sift_bytes<kBytes>(bgr, sieve, through);
  } else {
    sift_bytes<kBytes - 2>(bgr, sieve, through);
  }
  std::uint64_t any = 0;
  for (std::size_t i = 0; i < sizeof through; i += sizeof any) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, through + i, sizeof eight);
    any |= eight;
  }
  if (any == 0) return 0;
  std::uint64_t bits = 0;
  for (int u = 0; u < kBlock; ++u) bits |= std::uint64_t{through[3 * u]} << u;
  return bits;
}
#else
using Bytes = hn::CappedTag<std::uint8_t, kBlock>;

// Does one of a block's pixels get through the sieve?
HWY_INLINE bool any_coloured(const std::uint8_t* bgr, const Sieve& sieve) {
  const Bytes d;
  const int n = static_cast<int>(hn::Lanes(d));
  auto any = hn::Zero(d);
  for (int u = 0; u < kBlock; u += n) {
    auto b = hn::Zero(d);
    auto g = hn::Zero(d);
    auto r = hn::Zero(d);
    hn::LoadInterleaved3(d, bgr + std::ptrdiff_t{3} * u, b, g, r);
    const auto value = hn::Max(b, hn::Max(g, r));
    const auto chroma = hn::Sub(value, hn::Min(b, hn::Min(g, r)));
    const auto saturated = hn::Add(hn::And(hn::ShiftRight<1>(value), hn::Set(d, sieve.halves)),
                                   hn::Add(hn::And(hn::ShiftRight<2>(value), hn::Set(d, sieve.quarters)),
                                           hn::And(hn::ShiftRight<3>(value), hn::Set(d, sieve.eighths))));
    const auto least = hn::Max(saturated, hn::Set(d, sieve.chroma));
    any = hn::Or(any, hn::VecFromMask(d, hn::Eq(hn::Max(chroma, least), chroma)));
  }
  return !hn::AllFalse(d, hn::Ne(any, hn::Zero(d)));
}
#endif  // HWY_TARGET

}  // namespace markservo::mark_detector::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
