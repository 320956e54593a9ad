#include "common/geometry/camera_bounds.hpp"

#include <fmt/core.h>

#include "common/geometry/stereo_camera.hpp"

namespace markservo::geometry {

std::string implausibility(const StereoCamera& camera, int width_px, int height_px) {
  const struct {
    const char* name;
    double value;
    Bounds bounds;
    const char* unit;
  } numbers[] = {
      {"fx", camera.fx, focal_length_bounds(width_px), "px"},
      {"fy", camera.fy, focal_length_bounds(width_px), "px"},
      {"cx_left", camera.cx_left, principal_point_bounds(width_px), "px"},
      {"cx_right", camera.cx_right, principal_point_bounds(width_px), "px"},
      {"cy", camera.cy, principal_point_bounds(height_px), "px"},
      {"baseline", camera.baseline, kBaselineBounds, "m"},
  };
  for (const auto& number : numbers) {
    if (number.bounds.hold(number.value)) continue;
    return fmt::format("{} is {:.6g} {}; allowed: {:.6g} to {:.6g} {}", number.name, number.value, number.unit,
                       number.bounds.min, number.bounds.max, number.unit);
  }
  return {};
}

}  // namespace markservo::geometry
