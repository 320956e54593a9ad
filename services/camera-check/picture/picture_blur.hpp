#pragma once

// How blurred a picture is, by its own edges.

#include <opencv2/core.hpp>
#include <optional>

namespace markservo::camera_check {

struct BlurParameters {
  double least_gradient = 4.0;  // grey levels per px: fainter edges are shading
  double noise_factor = 10.0;   // times the gradient that noise alone makes: a tenth of an edge may be noise
  int least_edges = 100;        // pixels on edges; fewer tell nothing
  double sharpest_share = 0.2;  // scenes have soft edges too: the sharpest ones tell of the lens
};

// The blur of the picture's sharpest edges as the sigma of a Gaussian, px; nothing where too few edges stand out from
// the noise. Edges along u and along v are judged apart and the worse counts, so that a moved camera, which blurs one
// way only, is found as well. `grey`: 8 bit, one channel, as photographed.
//
// A step of height A, blurred by sigma and then smoothed by s, has a steepest slope of A / sqrt(2 pi (sigma^2 + s^2)),
// so that the ratio of the slopes at two s gives sigma, whatever A is (Zhuo and Sim, Defocus map estimation from a
// single image, Pattern Recognition 44, 2011, eq. 4 to 6, with smoothing in both terms against the noise).
std::optional<double> blur_of(const cv::Mat& grey, const BlurParameters& parameters = {});

}  // namespace markservo::camera_check
