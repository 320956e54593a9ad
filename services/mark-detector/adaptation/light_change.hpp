#pragma once

// How the light changed from one frame to the next, told from the whole image: no mark is needed.

#include <cstdint>
#include <vector>

#include "services/mark-detector/colour/hue.hpp"
#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

struct LightChangeParameters {
  // The rows that the histogram of lumas is made of, for they are at hand, and of these every few pixels: 600, whose
  // median is good to a percent.
  int rows = 30;
  int columns = 20;
  int darkest = 12;             // level; below it noise of sigma 3 and rounding hide a ratio
  int brightest = 245;          // level; above it a channel may be clipped
  int least_samples = 40;       // a channel; fewer tell nothing
  double alike_octaves = 0.35;  // how far a sample may be off the median: noise, and texture that moves
  double alike_share = 0.5;     // of the samples that must be so near, or the scene has changed, not the light
};

// The last frame's samples. Keeps its memory from frame to frame.
struct LightSamples {
  int width = 0;  // px, of the image they are from
  int height = 0;
  std::vector<std::uint8_t> bgr;
};

struct LightChange {
  Bgr gains{1.0, 1.0, 1.0};  // of each channel, now over last, between 1/16 and 16
  bool certain = false;      // every channel had samples enough, and most of them agree
};

// How light that changes by gain and colour cast (von Kries) did so. For each channel the median over the samples of
// the ratio of levels that are neither dark nor clipped in both frames; so what moves does not count while most of the
// image stays. A channel that cannot tell has the mean of those that can; all are 1 where none can, in the first frame,
// and for another size. `samples` becomes this frame's. Sizes of 1 px or more.
LightChange light_change(const ImageView& image, const LightChangeParameters& parameters, LightSamples& samples);

}  // namespace markservo::mark_detector
