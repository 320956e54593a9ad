#pragma once

// Which of several blobs of one colour is the mark: a pair, one per image, that one object can have made.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/mark-detector/blobs/blobs.hpp"
#include "services/mark-detector/views/pair_place.hpp"

namespace markservo::mark_detector {

struct SelectionParameters {
  double row_tolerance = 3.0;             // px, centroids' rows in a rectified pair
  double row_tolerance_of_height = 0.05;  // of the box's height, on top: slanted and half-hidden marks
  double height_ratio_max = 1.35;         // both see the same edge at the same depth
  double area_ratio_max = 1.8;            // a slanted mark is foreshortened differently for each camera
  double expected_area_min = 0.2;  // of the area a square facing the cameras has at this disparity: slant, hiding
  double expected_area_max = 2.0;  // likewise; above 1 for what blur adds
  int max_candidates = 32;         // blobs per image that are paired, the largest
};

// What is known of the mark and the cameras.
struct SelectionContext {
  double principal_offset = 0.0;            // px, cx_left - cx_right
  std::optional<double> size_per_baseline;  // edge of the mark / baseline; absent if not known or not a plane
  int image_width = 0;                      // px
  int image_height = 0;                     // px
};

struct Selection {
  std::optional<std::size_t> left;  // index of the blob
  std::optional<std::size_t> right;
  std::string reason;  // why there is no pair; empty if there is
};

// Why the two shapes cannot be one mark, with the numbers; empty if they can.
std::string inconsistency(const Shape& left, const Shape& right, const SelectionContext& context,
                          const SelectionParameters& parameters);

// Of the consistent pairs the one nearest to `last`, or, without it, the one with most pixels. With blobs in one image
// only, that image's nearest or largest; with blobs in both of which no two agree, none. Blobs come the largest first.
Selection select_pair(const std::vector<Blob>& left, const std::vector<Blob>& right, const SelectionContext& context,
                      const std::optional<PairPlace>& last, const SelectionParameters& parameters);

}  // namespace markservo::mark_detector
