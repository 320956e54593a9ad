#pragma once

// What the numbers of a rectified stereo pair can be: the same bounds wherever they are given, in a file, by an option
// or in a message. Outside them a unit, a file or the size of the pictures was taken for another.

#include <string>

namespace markservo::geometry {

struct StereoCamera;

// Both ends belong to it; not a number does not.
struct Bounds {
  double min = 0.0;
  double max = 0.0;

  constexpr bool hold(double value) const { return value >= min && value <= max; }
};

// m. Lenses have a size, and of cameras further apart than a robot is wide no near mark is seen by both.
inline constexpr Bounds kBaselineBounds{0.001, 2.0};

// px, for pictures of `width_px`: views from 157 degrees, where a flat picture ends to be of use, down to 2.
constexpr Bounds focal_length_bounds(int width_px) {
  return {0.1 * width_px, 30.0 * width_px};
}

// px, for pictures of `edge_px` along that axis: a picture may be cut out of a larger one, but not from far beside it.
constexpr Bounds principal_point_bounds(int edge_px) {
  return {-0.5 * edge_px, 1.5 * edge_px};
}

// "baseline is 65 m; allowed: 0.001 to 2 m": the first number of `camera` that is outside its bounds for pictures of
// `width_px` x `height_px` (above 0); empty where none is.
std::string implausibility(const StereoCamera& camera, int width_px, int height_px);

}  // namespace markservo::geometry
