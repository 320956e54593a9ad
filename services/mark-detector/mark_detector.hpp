#pragma once

// The paper's steps 1 and 2: equalise, classify by colour, find each mark's pixels in both images.

#include <array>
#include <bitset>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/stereo_camera.hpp"
#include "common/robot/robot_description.hpp"
#include "services/mark-detector/adaptation/colour_model.hpp"
#include "services/mark-detector/blobs/blobs.hpp"
#include "services/mark-detector/blobs/hole_filler.hpp"
#include "services/mark-detector/blobs/majority_filter.hpp"
#include "services/mark-detector/blobs/region.hpp"
#include "services/mark-detector/colour/colour_classifier.hpp"
#include "services/mark-detector/image_view.hpp"
#include "services/mark-detector/patches/patch_cutter.hpp"
#include "services/mark-detector/search/colour_scan.hpp"
#include "services/mark-detector/views/mark_selection.hpp"
#include "services/mark-detector/views/separability.hpp"

namespace markservo::mark_detector {

struct Parameters {
  bool equalise = true;
  // Looked at in each image, spread over it, and other ones in the right image than in the left, so that of 480 every
  // eighth counts: a level off at most. Whole rows, which processors fetch ahead.
  int histogram_rows = 30;
  int chroma_min = 14;          // levels; below it hue is noise (sigma 3 makes 5 on grey, 11 at the 99.9th percentile)
  std::int64_t min_area = 60;   // px; a mark of 8 x 8 px has no texture to match
  double hole_fraction = 0.1;   // of the blob's area: holes up to this are dirt, glare or print, and belong to the mark
  std::int64_t noise_hole = 9;  // px; holes up to this are noise, also in marks that are free
  int memory_frames = 30;       // frames for which the place of a mark that is not seen is remembered
  bool adapt = true;            // colour intervals follow the light
  ColourModelParameters colours;
  // Frames from one search of the whole image to the next; between them a mark is looked for around its last place, and
  // where it was not seen in every coarse_rows-th row. 1: always everywhere.
  int full_scan_every = 5;
  int coarse_rows = 8;   // px from row to row: a mark of 8 x 8 px crosses one
  int coarse_least = 4;  // px in one of them that make the whole image worth a search
  int track_margin = 8;  // px around a mark's last box, and an eighth of its size; outside all is searched
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
  BlobList left_blobs;  // all of its colour in the part that was searched, as classified
  BlobList right_blobs;
};

struct Output {
  std::vector<Finding> marks;  // every configured mark, in their order
};

// Memory of where marks were, for choosing between blobs and for where to look, and of the light; and room that is used
// again from frame to frame, so that none is asked for after the first.
struct State {
  struct Memory {
    bool known = false;
    LastSeen place;
    Shape left;  // as last seen
    Shape right;
    int width = 0;   // px of the images
    int height = 0;  // px
    int age = 0;     // frames since then
  };
  std::array<Memory, robot::kMaxMarks> memory;
  int frames_to_full_scan = 0;
  int next_coarse_row = 0;
  bool last_was_pair = false;

  ColourState colours;
  std::array<BitMask, robot::kMaxMarks> left_masks;
  std::array<BitMask, robot::kMaxMarks> right_masks;
  std::vector<FrameRule> rules;
  MajorityFilter filter;
  BitMask clean;
  BlobFinder finder;
  HoleFiller filler;
  std::vector<PixelRun> merged;
  std::vector<PixelRun> filled;
  SeparabilityMeter separability;
  PatchPlan patches;
  std::vector<PatchRequest> requests;
  std::vector<std::size_t> order;
  Output output;
};

class MarkDetector {
 public:
  // Throws std::invalid_argument if there are no marks or parameters are out of range.
  MarkDetector(std::vector<robot::MarkDescription> marks, const Parameters& parameters);

  // The answer is the state's, until the next step. A state belongs to one detector. Throws std::invalid_argument if
  // the left image is empty or the right one's size differs.
  const Output& step(const Input& input, State& state) const;

 private:
  using MarkSet = std::bitset<robot::kMaxMarks>;

  LumaShift equalise(const Input& input) const;
  MarkSet tracked_marks(const State& state) const;
  MarkSet marks_in_sight(const Input& input, const LumaShift& shift, MarkSet marks, State& state) const;
  void search_everywhere(const Input& input, const LumaShift& shift, MarkSet marks, State& state) const;
  bool search_around(const Input& input, const LumaShift& shift, std::size_t mark, State& state) const;
  void miss(const Input& input, std::size_t mark, State& state) const;
  void find_views(const Input& input, std::size_t mark, State& state) const;
  void remember(const Input& input, State& state) const;
  void make_view(const ImageView& image, std::size_t mark, const BlobList& list, const Blob* blob, State& state,
                 View& view) const;
  void cut_patches(const Input& input, State& state) const;

  std::vector<robot::MarkDescription> marks_;
  Parameters parameters_;
  std::vector<ColourRule> rules_;
  ColourModel colour_model_;
};

}  // namespace markservo::mark_detector
