#include "services/mark-detector/colour/colour_kernel.hpp"

#include <algorithm>
#include <cstddef>
#include <cstring>

#include "services/mark-detector/colour/pixel_block.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "services/mark-detector/colour/colour_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace markservo::mark_detector::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

constexpr int kBlock = imaging::BitMask::kWordBits;

using Bytes = hn::CappedTag<std::uint8_t, kBlock>;
using Levels = hn::CappedTag<std::int16_t, kBlock>;
using Wide = hn::CappedTag<std::int32_t, kBlock>;

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

// What the easiest of the rules asks for, in bytes and never more than that.
struct Sieve {
  std::uint8_t chroma = 255;
  std::uint8_t halves = 0;  // all bits set if the least saturation has that share in it, of value
  std::uint8_t quarters = 0;
  std::uint8_t eighths = 0;
};

Sieve make_sieve(const FrameRule* rules, int num_rules) {
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

std::uint32_t ClassifyRow(const std::uint8_t* bgr, int width, const FrameRule* rules, int num_rules,
                          const LumaShift& shift, std::uint64_t* const* words) {
  const Sieve sieve = make_sieve(rules, num_rules);
  std::uint32_t met = 0;
#if HWY_TARGET != HWY_SCALAR
  Features features;
#endif
  PixelBlock rest;
  for (int begin = 0, w = 0; begin < width; begin += kBlock, ++w) {
    const std::uint8_t* pixels = bgr + 3 * static_cast<std::ptrdiff_t>(begin);
    const int count = std::min(kBlock, width - begin);
    if (count < kBlock) pixels = pad_block(pixels, count, rest);
    const std::uint64_t within = count == kBlock ? ~std::uint64_t{0} : (std::uint64_t{1} << count) - 1;
#if HWY_TARGET == HWY_SCALAR
    std::uint64_t found[robot::kMaxMarks] = {};
    classify_pixels(pixels, sift(pixels, begin + kBlock < width, sieve) & within, rules, num_rules, shift, found);
    for (int k = 0; k < num_rules; ++k) {
      const std::uint64_t bits = found[k];
#else
    const bool coloured = any_coloured(pixels, sieve);
    if (coloured) extract(pixels, features);
    for (int k = 0; k < num_rules; ++k) {
      std::uint64_t bits = 0;
      if (coloured) {
        std::uint64_t doubt = 0;
        bits = belonging(rules[k], features, doubt) & within;
        for (doubt &= within; doubt != 0; doubt &= doubt - 1) {
          const int u = __builtin_ctzll(doubt);
          const std::uint8_t* p = pixels + std::ptrdiff_t{3} * u;
          const int shifted =
              std::clamp(features.value[u] + shift[static_cast<std::size_t>(luma(p[0], p[1], p[2]))], 0, 255);
          if (shifted < rules[k].rule.value_min || shifted > rules[k].rule.value_max) bits &= ~(std::uint64_t{1} << u);
        }
      }
#endif
      words[k][w] = bits;
      met |= static_cast<std::uint32_t>(bits != 0) << k;
    }
  }
  return met;
}

void CountLumaRow(const std::uint8_t* bgr, int width, LumaCounts& counts) {
  const Wide d;
  const hn::Rebind<std::uint8_t, Wide> bytes;
  const int n = static_cast<int>(hn::Lanes(d));
  HWY_ALIGN std::uint8_t lumas[kBlock];
  int u = 0;
  for (; u + kBlock <= width; u += kBlock) {
    for (int i = 0; i < kBlock; i += n) {
      auto b8 = hn::Zero(bytes);
      auto g8 = hn::Zero(bytes);
      auto r8 = hn::Zero(bytes);
      hn::LoadInterleaved3(bytes, bgr + std::ptrdiff_t{3} * (u + i), b8, g8, r8);
      auto sum = hn::Add(hn::Mul(hn::PromoteTo(d, b8), hn::Set(d, kLumaB)), hn::Set(d, 1 << (kLumaBits - 1)));
      sum = hn::Add(hn::Mul(hn::PromoteTo(d, g8), hn::Set(d, kLumaG)), sum);
      sum = hn::Add(hn::Mul(hn::PromoteTo(d, r8), hn::Set(d, kLumaR)), sum);
      hn::Store(hn::DemoteTo(bytes, hn::ShiftRight<kLumaBits>(sum)), bytes, lumas + i);
    }
    for (int i = 0; i < kBlock; i += 4) {
      for (std::size_t k = 0; k < 4; ++k) ++counts[k][lumas[static_cast<std::size_t>(i) + k]];
    }
  }
  for (; u < width; ++u) {
    const std::uint8_t* p = bgr + 3 * static_cast<std::ptrdiff_t>(u);
    ++counts[0][static_cast<std::size_t>(luma(p[0], p[1], p[2]))];
  }
}

}  // namespace markservo::mark_detector::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace markservo::mark_detector {

HWY_EXPORT(ClassifyRow);
HWY_EXPORT(CountLumaRow);

void frame_rules(const std::vector<ColourRule>& rules, const LumaShift& shift, std::vector<FrameRule>& result) {
  const auto [least, most] = std::minmax_element(shift.begin(), shift.end());
  result.clear();
  for (const ColourRule& rule : rules) {
    FrameRule frame_rule;
    frame_rule.rule = rule;
    // What equalisation would move beyond 0 or 255 stops there, and passes limits that lie there.
    constexpr std::int16_t kAny = 10000;  // beyond every level, and far from the type's end
    const auto narrow = [](int value) { return static_cast<std::int16_t>(value); };
    frame_rule.certain_min = rule.value_min <= 0 ? narrow(-kAny) : narrow(rule.value_min - *least);
    frame_rule.certain_max = rule.value_max >= 255 ? kAny : narrow(rule.value_max - *most);
    result.push_back(frame_rule);
  }
}

std::uint32_t classify_row(const std::uint8_t* bgr, int width, const FrameRule* rules, std::size_t num_rules,
                           const LumaShift& shift, std::uint64_t* const* words) {
  return HWY_DYNAMIC_DISPATCH(ClassifyRow)(bgr, width, rules, static_cast<int>(num_rules), shift, words);
}

void count_luma_row(const std::uint8_t* bgr, int width, LumaCounts& counts) {
  HWY_DYNAMIC_DISPATCH(CountLumaRow)(bgr, width, counts);
}

}  // namespace markservo::mark_detector
#endif  // HWY_ONCE
