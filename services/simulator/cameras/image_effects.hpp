#pragma once

// What a real camera does to a clean picture: blur, exposure and colour cast, noise. Seeded: the same arguments give
// the same pixels on every machine.

#include <cstdint>
#include <opencv2/core.hpp>

#include "services/simulator/cameras/image_settings.hpp"
#include "services/simulator/cameras/light_settings.hpp"

namespace markservo::simulator {

struct ImageEffects {
  double blur_px = 0.0;   // standard deviation, 0 or more
  double gain_red = 1.0;  // factors, 0 or more
  double gain_green = 1.0;
  double gain_blue = 1.0;
  double noise_sigma = 0.0;  // grey levels of 256, each channel, 0 or more
};

ImageEffects image_effects(const ImageSettings& image, const LightSettings& light);

// Changes `image` (CV_8UC3, blue first) in place: blur, then gains, then noise drawn from `noise_seed`; clipped to
// 0..255.
void apply_effects(const ImageEffects& effects, std::uint64_t noise_seed, cv::Mat& image);

// What each image of a frame draws its noise from.
struct NoiseSeeds {
  std::uint64_t left = 0;
  std::uint64_t right = 0;
};
NoiseSeeds noise_seeds(std::uint64_t seed, std::uint64_t frame_number);

}  // namespace markservo::simulator
