#pragma once

// Settings `sonar.*`: what is wrong with the ranges that the sonars tell.

#include "services/simulator/readers/sonar_model.hpp"
#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct SonarSettings {
  double noise = SonarParameters().noise;
  double dropout = SonarParameters().dropout;
};

inline constexpr Setting<SonarSettings> kSonarSettings[] = {
    {"sonar.noise", &SonarSettings::noise, 0.0, 1.0, TakesEffect::kAtOnce, "m, standard deviation of a range"},
    {"sonar.dropout", &SonarSettings::dropout, 0.0, 1.0, TakesEffect::kAtOnce, "share of echoes that are lost"},
};

inline SonarParameters sonar_parameters(const SonarSettings& settings) {
  return {settings.noise, settings.dropout};
}

}  // namespace markservo::simulator
