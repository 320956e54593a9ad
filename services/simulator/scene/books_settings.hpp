#pragma once

// Settings `books.*`: where the books stand, and how they slide.

#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct BooksSettings {
  double x = 0.0325;  // before the middle of the camera pair
  double y = 0.25;
  double slant_deg = 0.0;
  double friction = 0.5;
};

inline constexpr Setting<BooksSettings> kBooksSettings[] = {
    {"books.x", &BooksSettings::x, -1.0, 1.0, TakesEffect::kAtReset, "m, the middle book's mark in C"},
    {"books.y", &BooksSettings::y, 0.10, 1.0, TakesEffect::kAtReset, "m, the marks' plane in C"},
    {"books.slant_deg", &BooksSettings::slant_deg, -60.0, 60.0, TakesEffect::kAtReset,
     "deg, each book turned about the vertical through its mark's centre, counter-clockwise from above"},
    {"books.friction", &BooksSettings::friction, 0.05, 2.0, TakesEffect::kAtReset,
     "books on shelf, table and each other"},
};

}  // namespace markservo::simulator
