#include "services/mark-detector/mark_detector.hpp"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace markservo::mark_detector {
namespace {

// No string is made unless it is needed: frames are checked as well.
void check(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(std::string("MarkDetector: ") + what);
}

// Of all views that see the marks.
void measure_separability(const Input& input, SeparabilityMeter& meter, std::vector<Finding>& findings) {
  for (Finding& finding : findings) {
    finding.separability = 0.0;
    if (finding.left.seen) finding.separability = meter.measure(input.left, finding.left.region);
    if (finding.right.seen) {
      const double of_right = meter.measure(input.right, finding.right.region);
      finding.separability = finding.left.seen ? std::min(finding.separability, of_right) : of_right;
    }
  }
}

}  // namespace

MarkDetector::MarkDetector(std::vector<robot::MarkDescription> marks, const Parameters& parameters)
    : marks_(std::move(marks)),
      parameters_(parameters),
      colour_model_(marks_, parameters.chroma_min, parameters.colours) {
  const std::string number =
      std::to_string(marks_.size()) + " marks; allowed: 1 to " + std::to_string(robot::kMaxMarks);
  check(!marks_.empty() && marks_.size() <= robot::kMaxMarks, number.c_str());
  check(parameters_.histogram_rows >= 1, "histogram_rows below 1");
  check(parameters_.search.full_scan_every >= 1, "full_scan_every below 1 frame");
  check(parameters_.search.coarse_rows >= 1, "coarse_rows below 1 px");
  check(parameters_.search.track_margin >= 0, "track_margin below 0 px");
  check(parameters_.views.min_area >= 1, "min_area below 1 px");
  check(parameters_.patch.limit >= 1, "patch limit below 1 px");
  check(parameters_.patch.margin >= 0, "patch margin below 0 px");
  rules_.reserve(marks_.size());
  for (const auto& mark : marks_) rules_.push_back(make_rule(mark.colour, parameters_.chroma_min));
}

const Output& MarkDetector::step(const Input& input, State& state) const {
  check(!input.left.empty(), "the left image is empty");
  check(input.single() || (input.right.width == input.left.width && input.right.height == input.left.height),
        "the images' sizes differ");
  begin_frame(input, state);
  const LumaShift shift = equalise(input);
  frame_rules(parameters_.adapt ? colour_model_.rules(input.left, state.colours) : rules_, shift, state.work.rules);
  search(input, PairScan(input.left, input.right, shift, state.work.rules, state.work.masks), state);
  remember(input, state);
  measure_separability(input, state.work.separability, state.output.marks);
  state.work.patches.cut(input, parameters_.patch, state.output.marks);
  state.last_was_pair = !input.single();
  return state.output;
}

void MarkDetector::begin_frame(const Input& input, State& state) const {
  const int width = input.left.width;
  const int height = input.left.height;
  state.output.marks.resize(marks_.size());
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    state.output.marks[i].name = marks_[i].name;
    state.output.marks[i].role = marks_[i].role;
    state.tracks[i].begin_frame(width, height, parameters_.search.memory_frames);
  }
  state.work.masks.reset(marks_.size(), width, height);
}

// One table for both images, so that a mark is judged alike in both.
LumaShift MarkDetector::equalise(const Input& input) const {
  if (!parameters_.equalise) return no_shift();
  return against_darkness(equalising_shift(input.left, input.right, parameters_.histogram_rows));
}

// Everywhere, or where marks were and then everywhere for those that are not there.
void MarkDetector::search(const Input& input, const PairScan& scan, State& state) const {
  MarkSet everywhere;
  for (std::size_t i = 0; i < marks_.size(); ++i) everywhere.set(i);
  if (!state.schedule.full_scan_due(parameters_.search.full_scan_every, input.single())) {
    everywhere = search_where_marks_were(input, scan, state);
  }
  scan.search_everywhere(everywhere);
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    if (everywhere[i]) find_views(input, i, state);
  }
}

// The marks that are still to be searched for everywhere.
MarkSet MarkDetector::search_where_marks_were(const Input& input, const PairScan& scan, State& state) const {
  MarkSet followed;
  MarkSet others;
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    // A free mark is all that has its colour, wherever.
    const bool can_follow = state.tracks[i].is_fresh() && marks_[i].surface != robot::MarkSurface::kFree;
    (can_follow ? followed : others).set(i);
  }
  MarkSet everywhere;
  if (others.any()) {
    const int first_row = state.schedule.next_coarse_row(parameters_.search.coarse_rows);
    everywhere = scan.in_sight(others, first_row, parameters_.search);
  }
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    if (followed[i]) everywhere.set(i, !follow(input, scan, i, state));
    if (!followed[i] && !everywhere[i]) miss(input, i, state);
  }
  return everywhere;
}

// Near the last place; false if the mark is not there as a whole.
bool MarkDetector::follow(const Input& input, const PairScan& scan, std::size_t mark, State& state) const {
  const Track& track = state.tracks[mark];
  const PairWindow window = scan.search_around(mark, track.left, track.right, parameters_.search.track_margin);
  find_views(input, mark, state);
  const Finding& finding = state.output.marks[mark];
  return finding.seen_by_both() && !reaches_out(finding.left.shape, window.left, input.left) &&
         !reaches_out(finding.right.shape, window.right, input.right);
}

// A mark that no row shows anything of. What was too small to be it when everything was searched may still be there.
void MarkDetector::miss(const Input& input, std::size_t mark, State& state) const {
  Finding& finding = state.output.marks[mark];
  const bool too_small_before = !finding.left.seen && !finding.right.seen && finding.left_blobs.blobs.empty() &&
                                finding.right_blobs.blobs.empty() && state.last_was_pair;
  std::string before = std::move(finding.reason);
  find_views(input, mark, state);
  if (too_small_before && !before.empty()) finding.reason = std::move(before);
}

// From the masks, whatever part of the images they were made of.
void MarkDetector::find_views(const Input& input, std::size_t mark, State& state) const {
  const Track& track = state.tracks[mark];
  state.work.views.find(input, marks_[mark], state.work.masks.left[mark], state.work.masks.right[mark],
                        track.known ? std::make_optional(track.place) : std::nullopt, parameters_.views,
                        state.output.marks[mark]);
}

// Where the marks are that both images see, and what colour they have.
void MarkDetector::remember(const Input& input, State& state) const {
  if (input.single()) return;
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const Finding& finding = state.output.marks[i];
    if (!finding.seen_by_both()) continue;
    if (marks_[i].surface != robot::MarkSurface::kFree) {
      // It may be another thing if it is cut by the border, so that its size says nothing, or not of the mark's colour
      // in this light. Its place is not worth remembering.
      if (finding.left.clipped || finding.right.clipped) continue;
      if (parameters_.adapt && !colour_model_.observe(i, input.left, finding.left.region, input.right,
                                                      finding.right.region, state.colours)) {
        continue;
      }
    }
    state.tracks[i] = track_of(finding.left.shape, finding.right.shape, input.left.width, input.left.height);
  }
}

}  // namespace markservo::mark_detector
