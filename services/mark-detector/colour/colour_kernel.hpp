#pragma once

// The passes over pixels, in vector code for the processor it runs on (Highway): all targets give the same bits.

#include <array>
#include <cstddef>
#include <cstdint>

#include "services/mark-detector/colour/frame_rule.hpp"
#include "services/mark-detector/colour/luma_equalisation.hpp"

namespace markservo::mark_detector {

// Classifies a row of `width` pixels, 1 or more, of 8-bit BGR: words[k] receives the bits of the k-th of `num_rules`
// rules, one a pixel, lowest first, the last word padded with zeros. 1 to 8 rules. Returns which rules some pixel
// meets: bit k for the k-th.
std::uint32_t classify_row(const std::uint8_t* bgr, int width, const FrameRule* rules, std::size_t num_rules,
                           const LumaShift& shift, std::uint64_t* const* words);

// Counts the lumas of a row of `width` pixels. Four tables, to be added up: neighbours often have the same luma, and so
// their increments do not wait for each other.
using LumaCounts = std::array<std::array<std::uint32_t, 256>, 4>;
void count_luma_row(const std::uint8_t* bgr, int width, LumaCounts& counts);

}  // namespace markservo::mark_detector
