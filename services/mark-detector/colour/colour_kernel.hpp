#pragma once

// The passes over pixels, in vector code for the processor it runs on (Highway): all targets give the same bits.

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "services/mark-detector/colour/colour_classifier.hpp"
#include "services/mark-detector/colour/luma_equalisation.hpp"

namespace markservo::mark_detector {

// A rule, with what one frame's equalisation leaves of its value test. V is the photographed value, levels.
struct FrameRule {
  ColourRule rule;
  std::int16_t certain_min = 0;  // V from here ...
  std::int16_t certain_max = 0;  // ... to here passes the value test, whatever its luma
};

// The rules for a frame that is equalised by `shift`.
void frame_rules(const std::vector<ColourRule>& rules, const LumaShift& shift, std::vector<FrameRule>& result);

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
