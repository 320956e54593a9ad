#include "services/mark-detector/colour/colour_kernel.hpp"

#include <algorithm>
#include <cstddef>

#include "services/mark-detector/colour/pixel_block.hpp"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "services/mark-detector/colour/colour_kernel.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.
#include <hwy/highway.h>

#include "services/mark-detector/colour/colour_sieve-inl.h"
#include "services/mark-detector/colour/rule_tests-inl.h"

HWY_BEFORE_NAMESPACE();
namespace markservo::mark_detector::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

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
  std::uint8_t* const lumas = counts.block.data();
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
      for (std::size_t k = 0; k < 4; ++k) ++counts.tables[k][lumas[static_cast<std::size_t>(i) + k]];
    }
  }
  for (; u < width; ++u) {
    const std::uint8_t* p = bgr + 3 * static_cast<std::ptrdiff_t>(u);
    ++counts.tables[0][static_cast<std::size_t>(luma(p[0], p[1], p[2]))];
  }
}

}  // namespace markservo::mark_detector::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace markservo::mark_detector {

HWY_EXPORT(ClassifyRow);
HWY_EXPORT(CountLumaRow);

std::uint32_t classify_row(const std::uint8_t* bgr, int width, const FrameRule* rules, std::size_t num_rules,
                           const LumaShift& shift, std::uint64_t* const* words) {
  return HWY_DYNAMIC_DISPATCH(ClassifyRow)(bgr, width, rules, static_cast<int>(num_rules), shift, words);
}

void count_luma_row(const std::uint8_t* bgr, int width, LumaCounts& counts) {
  HWY_DYNAMIC_DISPATCH(CountLumaRow)(bgr, width, counts);
}

}  // namespace markservo::mark_detector
#endif  // HWY_ONCE
