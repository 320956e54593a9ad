#pragma once

// What the detector answers to one frame.

#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/blobs/blobs.hpp"
#include "services/mark-detector/blobs/region.hpp"
#include "services/mark-detector/blobs/shape.hpp"
#include "services/mark-detector/patches/patch.hpp"

namespace markservo::mark_detector {

// A mark in one image.
struct View {
  bool seen = false;
  bool clipped = false;  // the box touches the image's border
  Shape shape;
  Region region;
  Patch patch;  // scale 0 unless both images see the mark
};

struct Finding {
  std::string name;
  robot::MarkRole role = robot::MarkRole::kTarget;
  double separability = 0.0;  // 0..1, the worse of the views
  std::string reason;         // why it is not seen in one or both images; empty when all given images see it
  View left;
  View right;
  BlobList left_blobs;  // all of its colour in the part that was searched, as classified
  BlobList right_blobs;

  bool seen_by_both() const { return left.seen && right.seen; }
};

struct Output {
  std::vector<Finding> marks;  // every configured mark, in their order
};

}  // namespace markservo::mark_detector
