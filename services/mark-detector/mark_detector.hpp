#pragma once

// The paper's steps 1 and 2: equalise, classify by colour, find each mark's pixels in both images.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/stereo_camera.hpp"
#include "common/robot/robot_description.hpp"
#include "services/mark-detector/bit_mask.hpp"
#include "services/mark-detector/blobs.hpp"
#include "services/mark-detector/colour_classifier.hpp"
#include "services/mark-detector/image_view.hpp"
#include "services/mark-detector/mark_selection.hpp"
#include "services/mark-detector/outline.hpp"
#include "services/mark-detector/patch_cutter.hpp"
#include "services/mark-detector/region.hpp"

namespace markservo::mark_detector {

struct Parameters {
  bool equalise = true;
  int histogram_rows = 60;     // looked at, spread over the image: of 480 every eighth, a level off at most
  int chroma_min = 14;         // levels; below it hue is noise (sigma 3 makes 5 on grey, 11 at the 99.9th percentile)
  int64_t min_area = 60;       // px; a mark of 8 x 8 px has no texture to match
  double hole_fraction = 0.1;  // of the blob's area: holes up to this are dirt, glare or print, and belong to the mark
  int64_t noise_hole = 9;      // px; holes up to this are noise, also in marks that are free
  int memory_frames = 30;      // frames for which the place of a mark that is not seen is remembered
  OutlineParameters outline;
  SelectionParameters selection;
  PatchParameters patch;
};

struct Input {
  ImageView left;
  ImageView right;                               // of the left one's size, or empty: a single picture
  std::optional<geometry::StereoCamera> stereo;  // absent: marks' sizes are not checked
};

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
  BlobList left_blobs;  // all of its colour, as classified
  BlobList right_blobs;
};

struct Output {
  std::vector<Finding> marks;  // every configured mark, in their order
};

// Memory, only for choosing between blobs; and room that is used again from frame to frame.
struct State {
  struct Memory {
    LastSeen place;
    int age = 0;  // frames since
  };
  std::map<std::string, Memory> marks;
  std::vector<BitMask> left_masks;
  std::vector<BitMask> right_masks;
};

class MarkDetector {
 public:
  // Throws std::invalid_argument if there are no marks or parameters are out of range.
  MarkDetector(std::vector<robot::MarkDescription> marks, const Parameters& parameters);

  // Throws std::invalid_argument if the left image is empty or the right one's size differs.
  Output step(const Input& input, State& state) const;

 private:
  void find_views(const Input& input, State& state, const robot::MarkDescription& mark, Finding& finding) const;
  View make_view(const ImageView& image, const robot::MarkDescription& mark, const Blob& blob) const;
  void cut_patches(const Input& input, std::vector<Finding>& findings) const;

  std::vector<robot::MarkDescription> marks_;
  Parameters parameters_;
  std::vector<ColourRule> rules_;
};

}  // namespace markservo::mark_detector
