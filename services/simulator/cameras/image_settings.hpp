#pragma once

// Settings `image.*`: what lens and sensor do to a picture.

#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct ImageSettings {
  double noise_sigma = 3.0;
  double blur_px = 0.0;
};

inline constexpr Setting<ImageSettings> kImageSettings[] = {
    {"image.noise_sigma", &ImageSettings::noise_sigma, 0.0, 50.0, TakesEffect::kAtOnce,
     "grey levels of 256, Gaussian, each channel"},
    {"image.blur_px", &ImageSettings::blur_px, 0.0, 10.0, TakesEffect::kAtOnce,
     "px, standard deviation of the lens blur"},
};

}  // namespace markservo::simulator
