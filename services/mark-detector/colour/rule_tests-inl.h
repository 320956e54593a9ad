// The exact tests of a rule (colour_classifier.hpp) over a block of pixels, all but the value that equalisation leaves
// in doubt. Per target: included by the kernel, after hwy/highway.h. The scalar target has them pixel by pixel.

#if defined(MARKSERVO_RULE_TESTS_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef MARKSERVO_RULE_TESTS_INL_H
#undef MARKSERVO_RULE_TESTS_INL_H
#else
#define MARKSERVO_RULE_TESTS_INL_H
#endif

#include <cstddef>
#include <cstdint>
#include <cstring>

#include "services/mark-detector/colour/frame_rule.hpp"
#include "services/mark-detector/colour/pixel_block.hpp"

HWY_BEFORE_NAMESPACE();
namespace markservo::mark_detector::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Levels = hn::CappedTag<std::int16_t, kBlock>;
using Wide = hn::CappedTag<std::int32_t, kBlock>;

#if HWY_TARGET == HWY_SCALAR
// Pixel by pixel, for those that got through.
HWY_INLINE void classify_pixels(const std::uint8_t* pixels, std::uint64_t through, const FrameRule* rules,
                                int num_rules, const LumaShift& shift, std::uint64_t* bits) {
  for (; through != 0; through &= through - 1) {
    const int u = __builtin_ctzll(through);
    const std::uint8_t* p = pixels + std::ptrdiff_t{3} * u;
    const auto added = shift[static_cast<std::size_t>(luma(p[0], p[1], p[2]))];
    for (int k = 0; k < num_rules; ++k) {
      bits[k] |= std::uint64_t{belongs(rules[k].rule, p[0], p[1], p[2], added)} << u;
    }
  }
}
#else
// What the rules ask of a block of pixels.
struct HWY_ALIGN Features {
  HWY_ALIGN std::int16_t x[kBlock];
  HWY_ALIGN std::int16_t y[kBlock];
  HWY_ALIGN std::int16_t chroma[kBlock];
  HWY_ALIGN std::int16_t value[kBlock];
};

// The bits of `mask` as the lowest of a word.
template <class D, class M>
HWY_INLINE std::uint64_t bits_of(D d, M mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(d, mask, bytes);
  std::uint64_t word = 0;
  std::memcpy(&word, bytes, sizeof word);
  return word;
}

HWY_INLINE void extract(const std::uint8_t* bgr, Features& features) {
  const Levels d;
  const hn::Rebind<std::uint8_t, Levels> bytes;
  const int n = static_cast<int>(hn::Lanes(d));
  for (int u = 0; u < kBlock; u += n) {
    auto b8 = hn::Zero(bytes);
    auto g8 = hn::Zero(bytes);
    auto r8 = hn::Zero(bytes);
    hn::LoadInterleaved3(bytes, bgr + std::ptrdiff_t{3} * u, b8, g8, r8);
    const auto value = hn::PromoteTo(d, hn::Max(b8, hn::Max(g8, r8)));
    const auto g = hn::PromoteTo(d, g8);
    hn::Store(hn::Sub(hn::PromoteTo(d, r8), g), d, features.x + u);
    hn::Store(hn::Sub(g, hn::PromoteTo(d, b8)), d, features.y + u);
    hn::Store(hn::Sub(value, hn::PromoteTo(d, hn::Min(b8, hn::Min(g8, r8)))), d, features.chroma + u);
    hn::Store(value, d, features.value + u);
  }
}

// Where products of neighbours are added in one instruction, and in a known order, 16 bits hold what the tests need.
#define MARKSERVO_PAIRED_PRODUCTS (HWY_ARCH_X86 && HWY_TARGET != HWY_EMU128)

#if MARKSERVO_PAIRED_PRODUCTS
// The sign of a p + b q for each p and q, as 16 bits.
template <class D, class V>
HWY_INLINE V sign_of_sum(D d, V p, V q, int a, int b) {
  const hn::RepartitionToWide<D> wide;
  const auto factors = hn::BitCast(d, hn::Set(wide, static_cast<std::int32_t>((static_cast<std::uint32_t>(b) << 16) |
                                                                              static_cast<std::uint16_t>(a))));
  auto unused = hn::Zero(wide);
  const auto low = hn::ReorderWidenMulAccumulate(wide, hn::InterleaveLower(d, p, q), factors, hn::Zero(wide), unused);
  const auto high = hn::ReorderWidenMulAccumulate(wide, hn::InterleaveUpper(d, p, q), factors, hn::Zero(wide), unused);
  return hn::ReorderDemote2To(d, low, high);  // undoes the interleaving; saturates, which keeps signs
}

// The pixels that pass the exact tests of hue, saturation and chroma; `doubt` receives those of them whose luma decides
// about their value.
HWY_INLINE std::uint64_t belonging(const FrameRule& frame_rule, const Features& features, std::uint64_t& doubt) {
  const Levels d;
  const int n = static_cast<int>(hn::Lanes(d));
  const ColourRule& rule = frame_rule.rule;
  const auto minus_one = hn::Set(d, -1);
  std::uint64_t bits = 0;
  doubt = 0;
  for (int u = 0; u < kBlock; u += n) {
    const auto chroma = hn::Load(d, features.chroma + u);
    const auto value = hn::Load(d, features.value + u);
    // Negative where a test fails.
    auto fails = hn::Sub(chroma, hn::Set(d, rule.chroma_min));
    fails = hn::Or(fails, sign_of_sum(d, chroma, value, ColourRule::kSaturationScale, -rule.saturation_min));
    fails = hn::Or(fails, sign_of_sum(d, chroma, value, -ColourRule::kSaturationScale, rule.saturation_max));
    if (!rule.any_hue) {
      const auto x = hn::Load(d, features.x + u);
      const auto y = hn::Load(d, features.y + u);
      const auto before_min = sign_of_sum(d, x, y, -rule.min_y, rule.min_x);
      const auto after_max = sign_of_sum(d, x, y, rule.max_y, -rule.max_x);
      fails = hn::Or(fails, rule.wide ? hn::And(before_min, after_max) : hn::Or(before_min, after_max));
    }
    const std::uint64_t here = bits_of(d, hn::Gt(fails, minus_one));
    bits |= here << u;
    if (here == 0) continue;
    const auto uncertain =
        hn::Or(hn::Sub(value, hn::Set(d, frame_rule.certain_min)), hn::Sub(hn::Set(d, frame_rule.certain_max), value));
    doubt |= (here & ~bits_of(d, hn::Gt(uncertain, minus_one))) << u;
  }
  return bits;
}
#else
// a >= b, for numbers whose difference fits their type.
template <class D, class V>
HWY_INLINE auto at_least(D d, V a, V b) {
  return hn::Gt(hn::Sub(a, b), hn::Set(d, -1));
}

// The same in 32 bits.
HWY_INLINE std::uint64_t belonging(const FrameRule& frame_rule, const Features& features, std::uint64_t& doubt) {
  const Wide d;
  const hn::Rebind<std::int16_t, Wide> levels;
  const int n = static_cast<int>(hn::Lanes(d));
  const ColourRule& rule = frame_rule.rule;
  const auto load = [&](const std::int16_t* p) { return hn::PromoteTo(d, hn::Load(levels, p)); };
  const auto times = [&](std::int16_t factor, auto v) { return hn::Mul(hn::Set(d, factor), v); };
  std::uint64_t bits = 0;
  doubt = 0;
  for (int u = 0; u < kBlock; u += n) {
    const auto chroma = load(features.chroma + u);
    const auto value = load(features.value + u);
    const auto scaled = times(ColourRule::kSaturationScale, chroma);
    auto mask = hn::And(at_least(d, scaled, times(rule.saturation_min, value)),
                        at_least(d, times(rule.saturation_max, value), scaled));
    mask = hn::And(mask, at_least(d, chroma, hn::Set(d, rule.chroma_min)));
    if (!rule.any_hue) {
      const auto x = load(features.x + u);
      const auto y = load(features.y + u);
      const auto after_min = at_least(d, times(rule.min_x, y), times(rule.min_y, x));
      const auto before_max = at_least(d, times(rule.max_y, x), times(rule.max_x, y));
      mask = hn::And(mask, rule.wide ? hn::Or(after_min, before_max) : hn::And(after_min, before_max));
    }
    bits |= bits_of(d, mask) << u;
    const auto certain = hn::And(at_least(d, value, hn::Set(d, frame_rule.certain_min)),
                                 at_least(d, hn::Set(d, frame_rule.certain_max), value));
    doubt |= bits_of(d, hn::Not(certain)) << u;
  }
  doubt &= bits;
  return bits;
}
#endif  // MARKSERVO_PAIRED_PRODUCTS

#endif  // HWY_TARGET

}  // namespace markservo::mark_detector::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif  // per target
