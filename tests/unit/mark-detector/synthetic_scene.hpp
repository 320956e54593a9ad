#pragma once

// Pictures with marks whose place is known to a fraction of a pixel.

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector::test {

struct Colour {
  double b = 0.0;
  double g = 0.0;
  double r = 0.0;
};

inline constexpr Colour kRed{40.0, 35.0, 190.0};
inline constexpr Colour kGreen{50.0, 170.0, 40.0};
inline constexpr Colour kBlue{190.0, 70.0, 30.0};
inline constexpr Colour kYellow{30.0, 180.0, 200.0};
inline constexpr Colour kGrey{120.0, 120.0, 120.0};
inline constexpr Colour kWhite{235.0, 235.0, 235.0};
inline constexpr Colour kBlack{15.0, 15.0, 15.0};

// A square, turned by `angle` rad about its centre (px).
struct Square {
  double u = 0.0;
  double v = 0.0;
  double edge = 0.0;
  double angle = 0.0;
  Colour colour;
  double texture = 0.0;  // relative amplitude of a smooth pattern on it
};

class Picture {
 public:
  Picture(int width, int height, const Colour& background)
      : width_(width), height_(height), data_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 3) {
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) put(u, v, background);
    }
  }

  int width() const { return width_; }
  int height() const { return height_; }
  ImageView view() const { return {bytes_.data(), width_, height_, width_ * std::ptrdiff_t{3}}; }

  // Hard-edged, pixels [u, u + w) x [v, v + h) as far as they are in the picture.
  void fill(int u, int v, int w, int h, const Colour& colour) {
    for (int j = std::max(0, v); j < std::min(height_, v + h); ++j) {
      for (int i = std::max(0, u); i < std::min(width_, u + w); ++i) put(i, j, colour);
    }
  }

  // Area-averaged over 8 x 8 points a pixel.
  void draw(const Square& square) {
    constexpr int kSuper = 8;
    const double c = std::cos(square.angle);
    const double s = std::sin(square.angle);
    const int reach = static_cast<int>(std::ceil(square.edge)) + 2;
    const int u0 = static_cast<int>(std::lround(square.u));
    const int v0 = static_cast<int>(std::lround(square.v));
    for (int v = std::max(0, v0 - reach); v < std::min(height_, v0 + reach); ++v) {
      for (int u = std::max(0, u0 - reach); u < std::min(width_, u0 + reach); ++u) {
        int covered = 0;
        double light = 0.0;
        for (int k = 0; k < kSuper * kSuper; ++k) {
          const int row = k / kSuper;
          const int column = k % kSuper;
          const double du = u - 0.5 + (column + 0.5) / kSuper - square.u;
          const double dv = v - 0.5 + (row + 0.5) / kSuper - square.v;
          const double along = c * du + s * dv;
          const double across = -s * du + c * dv;
          if (std::abs(along) > 0.5 * square.edge || std::abs(across) > 0.5 * square.edge) continue;
          ++covered;
          light += 1.0 + square.texture * std::sin(0.9 * along + 0.3 * across) * std::sin(0.7 * across + 1.0);
        }
        if (covered == 0) continue;
        constexpr double kAll = kSuper * kSuper;
        const double alpha = covered / kAll;
        const Colour below = at(u, v);
        put(u, v,
            {(1.0 - alpha) * below.b + light / kAll * square.colour.b,
             (1.0 - alpha) * below.g + light / kAll * square.colour.g,
             (1.0 - alpha) * below.r + light / kAll * square.colour.r});
      }
    }
  }

  // Exposure with light of `gain` and Gaussian noise of `sigma` levels; makes what view() shows.
  Picture& expose(double gain = 1.0, double sigma = 0.0, unsigned seed = 1) {
    std::mt19937 random(seed);
    std::normal_distribution<double> noise(0.0, 1.0);
    bytes_.resize(data_.size());
    for (std::size_t i = 0; i < data_.size(); ++i) {
      const double level = gain * data_[i] + (sigma > 0.0 ? sigma * noise(random) : 0.0);
      bytes_[i] = static_cast<std::uint8_t>(std::clamp(std::lround(level), 0L, 255L));
    }
    return *this;
  }

 private:
  std::size_t index(int u, int v) const {
    return 3 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(u));
  }
  Colour at(int u, int v) const {
    const std::size_t i = index(u, v);
    return {data_[i], data_[i + 1], data_[i + 2]};
  }
  void put(int u, int v, const Colour& colour) {
    const std::size_t i = index(u, v);
    data_[i] = colour.b;
    data_[i + 1] = colour.g;
    data_[i + 2] = colour.r;
  }

  int width_;
  int height_;
  std::vector<double> data_;
  std::vector<std::uint8_t> bytes_;
};

}  // namespace markservo::mark_detector::test
