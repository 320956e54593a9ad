#pragma once

// The passes over pixels, in vector code for the processor it runs on (Highway): all targets give the same bits.

#include <array>
#include <cstddef>
#include <cstdint>

#include "services/mark-detector/colour/frame_rule.hpp"
#include "services/mark-detector/colour/luma_equalisation.hpp"
#include "services/mark-detector/colour/pixel_block.hpp"

namespace markservo::mark_detector {

// Classifies a row of `width` pixels, 1 or more, of 8-bit BGR: words[k] receives the bits of the k-th of `num_rules`
// rules, one a pixel, lowest first, the last word padded with zeros. 1 to 8 rules. Returns which rules some pixel
// meets: bit k for the k-th.
std::uint32_t classify_row(const std::uint8_t* bgr, int width, const FrameRule* rules, std::size_t num_rules,
                           const LumaShift& shift, std::uint64_t* const* words);

// How often each luma was met. Four tables, to be added up: neighbours often have the same luma, and so their
// increments do not wait for each other.
struct LumaCounts {
  static constexpr std::size_t kAlignment = 64;  // bytes, a cache line
  alignas(kAlignment) std::array<std::array<std::uint32_t, 256>, 4> tables{};
  // A block's lumas on their way into the tables. Behind them, since a processor takes a load for one that depends on
  // the last stores when their lowest 12 address bits agree: so it is the counts of 0 to 15 that wait, not those of
  // common lumas (Intel 64 and IA-32 Architectures Optimization Reference Manual, "4-KByte Aliasing").
  alignas(kAlignment) std::array<std::uint8_t, kBlock> block{};
};

// Counts the lumas of a row of `width` pixels.
void count_luma_row(const std::uint8_t* bgr, int width, LumaCounts& counts);

}  // namespace markservo::mark_detector
