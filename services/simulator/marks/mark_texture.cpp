#include "services/simulator/marks/mark_texture.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>
#include <stdexcept>

#include "services/simulator/random.hpp"

namespace markservo::simulator {
namespace {

std::uint64_t seed_of(const std::string& name) {
  std::uint64_t hash = 1469598103934665603ULL;  // FNV-1a, 64 bits
  for (const char letter : name) hash = (hash ^ static_cast<std::uint8_t>(letter)) * 1099511628211ULL;
  return hash;
}

// Smooth noise of unit variance. `sigma` in px.
cv::Mat1f smooth_noise(int edge, double sigma, std::uint64_t seed) {
  RandomBits bits(seed);
  cv::Mat1f noise(edge, edge);
  for (float& value : noise) value = static_cast<float>(bits.uniform() - 0.5);
  cv::GaussianBlur(noise, noise, cv::Size(), sigma, sigma, cv::BORDER_REFLECT);
  cv::Scalar mean;
  cv::Scalar deviation;
  cv::meanStdDev(noise, mean, deviation);
  noise -= mean[0];
  noise /= deviation[0];
  return noise;
}

// Spreads unit-variance noise over 0..1, flat in the middle of the range where most of it lies.
double spread(float noise) {
  return 0.5 * (1.0 + std::erf(static_cast<double>(noise) / std::sqrt(2.0)));
}

double between(const Eigen::Vector2d& range, double share) {
  return range[0] + (range[1] - range[0]) * share;
}

Rgb rgb_from_hsv(double hue_deg, double saturation, double value) {
  Rgb rgb;
  const double offsets[] = {5.0, 3.0, 1.0};
  for (int i = 0; i < 3; ++i) {
    const double k = std::fmod(offsets[i] + hue_deg / 60.0 + 6.0, 6.0);
    rgb[i] = value - value * saturation * std::clamp(std::min(k, 4.0 - k), 0.0, 1.0);
  }
  return rgb;
}

// What a look makes of the print.
struct Inking {
  double contrast = 1.0;    // of the print's variation
  double saturation = 1.0;  // of the print's
  double shade = 1.0;       // of the light in the shadow over a part of the mark
};

Inking inking_of(MarkLook look) {
  switch (look) {
    case MarkLook::kPrinted:
      break;
    case MarkLook::kPlain:
    case MarkLook::kGlossy:
      return {0.0, 1.0, 1.0};
    case MarkLook::kFaded:
      return {0.15, 0.85, 1.0};
    case MarkLook::kPartlyLit:
      return {0.0, 1.0, 0.6};
  }
  return {};
}

void check_edge(int edge) {
  if (edge < 16 || edge > 4096) {
    throw std::invalid_argument("texture edge is " + std::to_string(edge) + " px; allowed: 16 to 4096");
  }
}

std::uint8_t level(double share) {
  return static_cast<std::uint8_t>(std::lround(std::clamp(share, 0.0, 1.0) * 255.0));
}

}  // namespace

Texture mark_texture(const robot::MarkDescription& mark, const PrintScene& print, int edge, MarkLook look) {
  check_edge(edge);
  const Inking inking = inking_of(look);
  const std::uint64_t seed = seed_of(mark.name);
  const double sigma = print.grain * edge;
  const cv::Mat1f value_noise = smooth_noise(edge, sigma, seed);
  const cv::Mat1f saturation_noise = smooth_noise(edge, sigma, seed + 1);
  const cv::Mat1f hue_noise = smooth_noise(edge, 2.0 * sigma, seed + 2);

  const double width = std::fmod(mark.colour.hue_max_deg - mark.colour.hue_min_deg + 360.0, 360.0);
  const double middle = mark.colour.hue_min_deg + 0.5 * width;
  // 0..1 about a half, as far apart as the print leaves them.
  const auto ink = [&inking](float noise) { return 0.5 + inking.contrast * (spread(noise) - 0.5); };
  Texture texture{edge, {}};
  texture.rgb.reserve(static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge) * 3);
  for (int row = 0; row < edge; ++row) {
    for (int column = 0; column < edge; ++column) {
      const double hue = middle + (ink(hue_noise(row, column)) - 0.5) * width * print.hue_share;
      const double saturation = inking.saturation * between(print.saturation, ink(saturation_noise(row, column)));
      const Rgb rgb = rgb_from_hsv(hue, saturation, between(print.value, ink(value_noise(row, column))));
      // The shadow's border crosses the mark at a slant.
      const bool shaded = row + column / 2 > edge;
      for (int i = 0; i < 3; ++i) texture.rgb.push_back(level(rgb[i] * (shaded ? inking.shade : 1.0)));
    }
  }
  return texture;
}

Texture surface_texture(const Rgb& colour, double contrast, const std::string& name, int edge) {
  check_edge(edge);
  const std::uint64_t seed = seed_of(name);
  const cv::Mat1f fine = smooth_noise(edge, 0.006 * edge, seed);
  const cv::Mat1f coarse = smooth_noise(edge, 0.05 * edge, seed + 1);
  Texture texture{edge, {}};
  texture.rgb.reserve(static_cast<std::size_t>(edge) * static_cast<std::size_t>(edge) * 3);
  for (int row = 0; row < edge; ++row) {
    for (int column = 0; column < edge; ++column) {
      const double change = spread(fine(row, column)) + spread(coarse(row, column)) - 1.0;
      for (int i = 0; i < 3; ++i) texture.rgb.push_back(level(colour[i] * (1.0 + contrast * change)));
    }
  }
  return texture;
}

}  // namespace markservo::simulator
