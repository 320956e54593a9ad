#pragma once

// Settings `marks.*`: what people glue on their things.

#include "common/robot/robot_description.hpp"
#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

// As marks.print numbers them.
enum class MarkLook {
  kPrinted,    // a texture to match by
  kPlain,      // one colour
  kFaded,      // the print's colours after years of sun: paler, and nearly alike
  kGlossy,     // one colour that shines where the light falls
  kPartlyLit,  // one colour, a shadow over a part of it
};

struct MarkSettings {
  double print = 0.0;
  double covered = 0.0;

  MarkLook look() const { return static_cast<MarkLook>(static_cast<int>(print)); }
};

inline constexpr Setting<MarkSettings> kMarkSettings[] = {
    {"marks.print", &MarkSettings::print, 0.0, 4.0, TakesEffect::kAtReset,
     "what all marks look like; 0: printed, 1: plain, 2: faded, 3: glossy, 4: partly lit", true},
    {"marks.covered", &MarkSettings::covered, 0.0, static_cast<double>(robot::kMaxMarks), TakesEffect::kAtOnce,
     "somebody has laid a grey card over this mark, by its place in robot.yaml from 1; 0: over none", true},
};

}  // namespace markservo::simulator
