#pragma once

// The room around the robot as MuJoCo's MJCF: walls, furniture and what stands about.

#include <string>

#include "services/simulator/scene/books_settings.hpp"
#include "services/simulator/scene/scene.hpp"

namespace markservo::simulator {

// Geoms in S. Needs the materials wall, floor, wood and matt.
std::string room_geoms(const Scene& scene);
std::string furniture_geoms(const Scene& scene, const BooksSettings& settings);

}  // namespace markservo::simulator
