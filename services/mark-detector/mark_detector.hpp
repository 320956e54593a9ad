#pragma once

// The paper's steps 1 and 2: equalise, classify by colour, find each mark's pixels in both images.

#include <array>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/adaptation/colour_model.hpp"
#include "services/mark-detector/colour/colour_classifier.hpp"
#include "services/mark-detector/colour/frame_rule.hpp"
#include "services/mark-detector/colour/luma_equalisation.hpp"
#include "services/mark-detector/detector_input.hpp"
#include "services/mark-detector/detector_output.hpp"
#include "services/mark-detector/patches/pair_patches.hpp"
#include "services/mark-detector/search/pair_scan.hpp"
#include "services/mark-detector/search/search_schedule.hpp"
#include "services/mark-detector/search/track.hpp"
#include "services/mark-detector/views/separability.hpp"
#include "services/mark-detector/views/view_finder.hpp"

namespace markservo::mark_detector {

struct Parameters {
  bool equalise = true;
  // Looked at in each image, spread over it, and other ones in the right image than in the left, so that of 480 every
  // eighth counts: a level off at most. Whole rows, which processors fetch ahead.
  int histogram_rows = 30;
  int chroma_min = 14;  // levels; below it hue is noise (sigma 3 makes 5 on grey, 11 at the 99.9th percentile)
  bool adapt = true;    // colour intervals follow the light
  ColourModelParameters colours;
  SearchParameters search;
  ViewParameters views;
  PatchParameters patch;
};

// Room that is used again from frame to frame, so that none is asked for after the first.
struct Workspace {
  std::vector<FrameRule> rules;  // one a mark
  PairMasks masks;
  ViewFinder views;
  SeparabilityMeter separability;
  PairPatches patches;
};

// Memory from frame to frame.
struct State {
  std::array<Track, robot::kMaxMarks> tracks;  // where marks were: for choosing between blobs, and for where to look
  SearchSchedule schedule;
  ColourState colours;         // of the marks in the light of the moment
  Output output;               // the last answer; a mark that nothing shows keeps its reason
  bool last_was_pair = false;  // what it answers to
  Workspace work;
};

class MarkDetector {
 public:
  // Throws std::invalid_argument if there are no marks or parameters are out of range.
  MarkDetector(std::vector<robot::MarkDescription> marks, const Parameters& parameters);

  // The answer is the state's, until the next step. A state belongs to one detector. Throws std::invalid_argument if
  // the left image is empty or the right one's size differs.
  const Output& step(const Input& input, State& state) const;

 private:
  void begin_frame(const Input& input, State& state) const;
  LumaShift equalise(const Input& input) const;
  void search(const Input& input, const PairScan& scan, State& state) const;
  MarkSet search_where_marks_were(const Input& input, const PairScan& scan, State& state) const;
  bool follow(const Input& input, const PairScan& scan, std::size_t mark, State& state) const;
  void miss(const Input& input, std::size_t mark, State& state) const;
  void find_views(const Input& input, std::size_t mark, State& state) const;
  void remember(const Input& input, State& state) const;

  std::vector<robot::MarkDescription> marks_;
  Parameters parameters_;
  std::vector<ColourRule> rules_;
  ColourModel colour_model_;
};

}  // namespace markservo::mark_detector
