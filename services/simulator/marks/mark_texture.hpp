#pragma once

// The printed textures of the simulated world: smooth noise, so that image gradients carry sub-pixel matching.

#include <cstdint>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/simulator/marks/mark_settings.hpp"
#include "services/simulator/scene/scene.hpp"

namespace markservo::simulator {

// A square picture, edge x edge pixels of red, green, blue.
struct Texture {
  int edge = 0;  // px
  std::vector<std::uint8_t> rgb;
};

// The print of a mark: hue, saturation and value vary smoothly within the mark's colour interval as `print` allows. The
// print depends on the mark's name and `edge` only, so a mark looks the same in every run. edge: 16 to 4096 px.
// Other looks (marks.print) are of the print's middle colour, or of its colours as they fade.
Texture mark_texture(const robot::MarkDescription& mark, const PrintScene& print, int edge,
                     MarkLook look = MarkLook::kPrinted);

// Wallpaper or floor: `colour` with smooth noise of +-`contrast` (0..1) at two scales.
Texture surface_texture(const Rgb& colour, double contrast, const std::string& name, int edge);

}  // namespace markservo::simulator
