#include "services/mark-detector/colour/frame_rule.hpp"

#include <algorithm>

namespace markservo::mark_detector {

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

}  // namespace markservo::mark_detector
