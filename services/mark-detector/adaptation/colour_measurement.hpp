#pragma once

// What colour a mark shows in an image pair.

#include "services/mark-detector/blobs/region.hpp"
#include "services/mark-detector/colour/hue.hpp"
#include "services/mark-detector/image_view.hpp"

namespace markservo::mark_detector {

inline constexpr int kMaxSamplesPerSide = 16;

struct ColourMeasurementParameters {
  int samples_per_side = 16;  // rows and columns looked at of the window around a mark, 1 to kMaxSamplesPerSide
  int least_samples = 12;     // unclipped pixels that make a measurement
};

// Mean and relative standard deviation of what the camera would show if it did not clip.
struct ColourMeasurement {
  Bgr mean{};           // levels; 0 without an unclipped pixel
  double spread = 0.0;  // of the brightness, share of the mean
  int unclipped = 0;    // pixels that are neither clipped nor dark
};

// Measures pixels well inside the mark in both images.
ColourMeasurement measure_colour(const ImageView& left, const Region& in_left, const ImageView& right,
                                 const Region& in_right, int samples_per_side);

}  // namespace markservo::mark_detector
