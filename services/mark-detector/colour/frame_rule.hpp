#pragma once

// A mark's colour under one frame's equalisation.

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

}  // namespace markservo::mark_detector
