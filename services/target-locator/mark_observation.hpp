#pragma once

// What the locator is told about one mark in one image pair.

#include <cstdint>

#include "services/target-locator/image/patch_frame.hpp"

namespace markservo::target_locator {

// The mark's surroundings, as photographed (not equalised), with the mark's mask.
struct Patch {
  PatchFrame frame;
  int width = 0;                       // patch pixels; 0: no patch
  int height = 0;                      // patch pixels
  const std::uint8_t* bgr = nullptr;   // width * height * 3 bytes, not owned
  const std::uint8_t* mask = nullptr;  // height rows of (width + 7) / 8 bytes, lowest bit first, not owned

  bool empty() const { return width <= 0 || height <= 0 || bgr == nullptr || mask == nullptr; }
};

// The mark as one camera sees it.
struct View {
  bool seen = false;
  bool clipped = false;  // part of the mark is outside the image
  double x = 0.0;        // px, box: left column
  double y = 0.0;        // px, box: top row
  double width = 0.0;    // px
  double height = 0.0;   // px
  Patch patch;

  double centre_u() const { return x + 0.5 * (width - 1.0); }   // px, of the box
  double centre_v() const { return y + 0.5 * (height - 1.0); }  // px, of the box
};

enum class Surface { kPlane, kFree, kBall };
enum class Outline { kSquare, kDisc, kOther };  // of a plane

struct MarkObservation {
  View left;
  View right;
  Surface surface = Surface::kPlane;
  Outline outline = Outline::kSquare;
  double size = 0.0;  // m, edge of the square, diameter of a disc or ball; 0: unknown
};

}  // namespace markservo::target_locator
