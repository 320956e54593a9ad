#include "services/mark-detector/mark_detector.hpp"

#include <algorithm>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "services/mark-detector/colour/luma_equalisation.hpp"

namespace markservo::mark_detector {
namespace {

// No string is made unless it is needed: frames are checked as well.
void check(bool condition, const char* what) {
  if (!condition) throw std::invalid_argument(std::string("MarkDetector: ") + what);
}

// Why one image shows no blob of the mark.
std::string why_not(const BlobList& blobs, std::int64_t min_area, const char* where) {
  if (blobs.largest_area == 0) return std::string("no pixel of its colour in ") + where;
  return std::string("largest blob in ") + where + " has " + std::to_string(blobs.largest_area) + " px, fewer than " +
         std::to_string(min_area);
}

std::string why_unseen(const Finding& finding, std::int64_t min_area, bool single) {
  const bool left = !finding.left_blobs.blobs.empty();
  const bool right = !finding.right_blobs.blobs.empty();
  if (single) return left ? "" : why_not(finding.left_blobs, min_area, "the image");
  if (left && !right)
    return "seen in the left image only: " + why_not(finding.right_blobs, min_area, "the right image");
  if (right && !left) return "seen in the right image only: " + why_not(finding.left_blobs, min_area, "the left image");
  if (finding.left_blobs.largest_area == 0 && finding.right_blobs.largest_area == 0) {
    return "no pixel of its colour in either image";
  }
  return why_not(finding.left_blobs, min_area, "the left image") + "; " +
         why_not(finding.right_blobs, min_area, "the right image");
}

LastSeen place_of(const Finding& finding) {
  return {finding.left.shape.u, finding.left.shape.v, finding.right.shape.u};
}

double distance_2(const LastSeen& a, const LastSeen& b) {
  const double du_left = a.u_left - b.u_left;
  const double dv = a.v_left - b.v_left;
  const double du_right = a.u_right - b.u_right;
  return du_left * du_left + dv * dv + du_right * du_right;
}

// Indices of the marks that both images see: the hand, then targets from the one next to the hand outwards; without a
// hand, from the middle of the image outwards. What the arm works on is so served first.
void by_importance(const std::vector<Finding>& findings, int width, int height, std::vector<std::size_t>& order) {
  order.clear();
  LastSeen focus{0.5 * (width - 1), 0.5 * (height - 1), 0.5 * (width - 1)};
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Finding& finding = findings[i];
    if (!finding.left.seen || !finding.right.seen) continue;
    order.push_back(i);
    if (finding.role == robot::MarkRole::kManipulator) focus = place_of(finding);
  }
  const auto rank = [&](std::size_t i) {
    const bool hand = findings[i].role == robot::MarkRole::kManipulator;
    return std::make_tuple(hand ? 0 : 1, distance_2(place_of(findings[i]), focus), i);
  };
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
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
  check(parameters_.full_scan_every >= 1, "full_scan_every below 1 frame");
  check(parameters_.coarse_rows >= 1, "coarse_rows below 1 px");
  check(parameters_.track_margin >= 0, "track_margin below 0 px");
  check(parameters_.min_area >= 1, "min_area below 1 px");
  check(parameters_.patch.limit >= 1, "patch limit below 1 px");
  check(parameters_.patch.margin >= 0, "patch margin below 0 px");
  rules_.reserve(marks_.size());
  for (const auto& mark : marks_) rules_.push_back(make_rule(mark.colour, parameters_.chroma_min));
}

const Output& MarkDetector::step(const Input& input, State& state) const {
  check(!input.left.empty(), "the left image is empty");
  const bool single = input.right.empty();
  check(single || (input.right.width == input.left.width && input.right.height == input.left.height),
        "the images' sizes differ");
  state.output.marks.resize(marks_.size());
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    state.output.marks[i].name = marks_[i].name;
    state.output.marks[i].role = marks_[i].role;
    for (auto* masks : {&state.left_masks, &state.right_masks}) (*masks)[i].reset(input.left.width, input.left.height);
    State::Memory& memory = state.memory[i];
    const bool same_size = memory.width == input.left.width && memory.height == input.left.height;
    if (memory.known && (++memory.age > parameters_.memory_frames || !same_size)) memory.known = false;
  }
  const LumaShift shift = equalise(input);
  frame_rules(parameters_.adapt ? colour_model_.rules(input.left, state.colours) : rules_, shift, state.rules);

  MarkSet everywhere;
  for (std::size_t i = 0; i < marks_.size(); ++i) everywhere.set(i);
  if (single || --state.frames_to_full_scan <= 0) {
    state.frames_to_full_scan = parameters_.full_scan_every;
  } else {
    const MarkSet tracked = tracked_marks(state);
    everywhere = marks_in_sight(input, shift, everywhere & ~tracked, state);
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      if (tracked[i]) everywhere.set(i, !search_around(input, shift, i, state));
      if (!tracked[i] && !everywhere[i]) miss(input, i, state);
    }
  }
  search_everywhere(input, shift, everywhere, state);
  remember(input, state);

  for (Finding& finding : state.output.marks) {
    finding.separability = 0.0;
    if (finding.left.seen) finding.separability = state.separability.measure(input.left, finding.left.region);
    if (finding.right.seen) {
      const double of_right = state.separability.measure(input.right, finding.right.region);
      finding.separability = finding.left.seen ? std::min(finding.separability, of_right) : of_right;
    }
  }
  cut_patches(input, state);
  state.last_was_pair = !single;
  return state.output;
}

// One table for both images, so that a mark is judged alike in both.
LumaShift MarkDetector::equalise(const Input& input) const {
  if (!parameters_.equalise) return no_shift();
  return against_darkness(equalising_shift(input.left, input.right, parameters_.histogram_rows));
}

// The marks that both images of the frame before showed. A free mark is all that has its colour, wherever.
MarkDetector::MarkSet MarkDetector::tracked_marks(const State& state) const {
  MarkSet tracked;
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const State::Memory& memory = state.memory[i];
    tracked.set(i, memory.known && memory.age == 1 && marks_[i].surface == robot::MarkSurface::kPlane);
  }
  return tracked;
}

// Of `marks` those that a few rows show something of.
MarkDetector::MarkSet MarkDetector::marks_in_sight(const Input& input, const LumaShift& shift, MarkSet marks,
                                                   State& state) const {
  MarkSet in_sight;
  if (marks.none()) return in_sight;
  state.next_coarse_row = (state.next_coarse_row + 1) % parameters_.coarse_rows;
  for (const auto& [image, masks] :
       {std::pair(&input.left, &state.left_masks), std::pair(&input.right, &state.right_masks)}) {
    ScanRules rules;
    std::array<std::size_t, robot::kMaxMarks> mark_of_rule{};
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      if (!marks[i] || in_sight[i]) continue;
      mark_of_rule.at(rules.count) = i;
      rules.add(state.rules[i], (*masks)[i]);
    }
    if (rules.count == 0) break;
    const std::uint32_t found =
        scan_rows(*image, state.next_coarse_row, parameters_.coarse_rows, parameters_.coarse_least, shift, rules);
    for (std::size_t k = 0; k < rules.count; ++k) {
      if (((found >> k) & 1U) != 0) in_sight.set(mark_of_rule.at(k));
    }
  }
  return in_sight;
}

void MarkDetector::search_everywhere(const Input& input, const LumaShift& shift, MarkSet marks, State& state) const {
  if (marks.none()) return;
  for (const auto& [image, masks] :
       {std::pair(&input.left, &state.left_masks), std::pair(&input.right, &state.right_masks)}) {
    if (image->empty()) continue;
    ScanRules rules;
    for (std::size_t i = 0; i < marks_.size(); ++i) {
      if (marks[i]) rules.add(state.rules[i], (*masks)[i]);
    }
    scan(*image, whole_image(*image), shift, rules);
  }
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    if (marks[i]) find_views(input, i, state);
  }
}

// Near the last place; false if the mark is not there as a whole.
bool MarkDetector::search_around(const Input& input, const LumaShift& shift, std::size_t mark, State& state) const {
  const State::Memory& memory = state.memory[mark];
  const auto scan_side = [&](const ImageView& image, const Shape& last, BitMask& mask) {
    const ScanWindow window =
        window_around(last, parameters_.track_margin + std::max(last.width, last.height) / 8, image);
    ScanRules rules;
    rules.add(state.rules[mark], mask);
    scan(image, window, shift, rules);
    return window;
  };
  const ScanWindow left = scan_side(input.left, memory.left, state.left_masks[mark]);
  const ScanWindow right = scan_side(input.right, memory.right, state.right_masks[mark]);
  find_views(input, mark, state);
  const Finding& finding = state.output.marks[mark];
  return finding.left.seen && finding.right.seen && !reaches_out(finding.left.shape, left, input.left) &&
         !reaches_out(finding.right.shape, right, input.right);
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
  const bool single = input.right.empty();
  const robot::MarkDescription& description = marks_[mark];
  Finding& finding = state.output.marks[mark];
  const State::Memory& memory = state.memory[mark];
  BlobParameters blobs;
  blobs.min_area = parameters_.min_area;
  const auto find = [&](const BitMask& mask, BlobList& list) {
    state.filter.apply(mask, state.clean);
    state.finder.find(state.clean, blobs, list);
  };
  find(state.left_masks[mark], finding.left_blobs);
  find(state.right_masks[mark], finding.right_blobs);
  const std::vector<Blob>& left = finding.left_blobs.blobs;
  const std::vector<Blob>& right = finding.right_blobs.blobs;

  finding.reason.clear();
  Selection selection;
  if (description.surface == robot::MarkSurface::kFree) {
    // Not one flat piece: everything of its colour is the mark.
    if (!left.empty()) selection.left = 0;
    if (!right.empty()) selection.right = 0;
  } else {
    SelectionContext context;
    context.image_width = input.left.width;
    context.image_height = input.left.height;
    if (input.stereo) {
      context.principal_offset = input.stereo->cx_left - input.stereo->cx_right;
      if (description.size > 0.0) context.size_per_baseline = description.size / input.stereo->baseline;
    }
    selection = select_pair(left, right, context, memory.known ? std::make_optional(memory.place) : std::nullopt,
                            parameters_.selection);
    finding.reason = selection.reason;
  }
  make_view(input.left, mark, finding.left_blobs, selection.left ? &left[*selection.left] : nullptr, state,
            finding.left);
  make_view(input.right, mark, finding.right_blobs, selection.right ? &right[*selection.right] : nullptr, state,
            finding.right);
  const bool complete = finding.left.seen && (single || finding.right.seen);
  if (!complete && finding.reason.empty()) finding.reason = why_unseen(finding, parameters_.min_area, single);
}

// Where the marks are that both images see, and what colour they have.
void MarkDetector::remember(const Input& input, State& state) const {
  if (input.right.empty()) return;
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    const Finding& finding = state.output.marks[i];
    if (!finding.left.seen || !finding.right.seen) continue;
    if (marks_[i].surface == robot::MarkSurface::kPlane) {
      // It may be another thing if it is cut by the border, so that its size says nothing, or not of the mark's colour
      // in this light. Its place is not worth remembering.
      if (finding.left.clipped || finding.right.clipped) continue;
      if (parameters_.adapt && !colour_model_.observe(i, input.left, finding.left.region, input.right,
                                                      finding.right.region, state.colours)) {
        continue;
      }
    }
    state.memory[i] = {
        true, place_of(finding), finding.left.shape, finding.right.shape, input.left.width, input.left.height, 0};
  }
}

// `blob`: of the list, or none.
void MarkDetector::make_view(const ImageView& image, std::size_t mark, const BlobList& list, const Blob* blob,
                             State& state, View& view) const {
  view.seen = blob != nullptr;
  view.clipped = false;
  view.shape = {};
  RunSpan runs;
  if (blob != nullptr) {
    const bool plane = marks_[mark].surface == robot::MarkSurface::kPlane;
    runs = list.runs_of(*blob);
    double area = blob->shape.area;
    if (!plane) {
      merge(list, state.merged);
      runs = state.merged;
      area = shape_of(runs).area;
    }
    const auto fraction = static_cast<std::int64_t>(parameters_.hole_fraction * area);
    state.filler.fill(runs, plane ? std::max(parameters_.noise_hole, fraction) : parameters_.noise_hole, state.filled);
    runs = state.filled;
    view.shape = shape_of(runs);
    view.clipped = is_clipped(view.shape, image.width, image.height);
  }
  make_region(runs, view.shape, SeparabilityMeter::margin(view.shape), image.width, image.height, view.region);
}

void MarkDetector::cut_patches(const Input& input, State& state) const {
  std::vector<Finding>& findings = state.output.marks;
  for (Finding& finding : findings) {
    for (View* view : {&finding.left, &finding.right}) {
      view->patch.scale = view->patch.width = view->patch.height = 0;
      view->patch.bgr.clear();
      view->patch.mask.clear();
    }
  }
  if (input.right.empty()) return;
  const int width = input.left.width;
  const int height = input.left.height;
  by_importance(findings, width, height, state.order);
  state.requests.clear();
  for (const std::size_t i : state.order) state.requests.push_back({findings[i].left.shape, findings[i].right.shape});
  plan_scales(state.requests, parameters_.patch, width, height, state.patches);
  for (std::size_t k = 0; k < state.order.size(); ++k) {
    const int scale = state.patches.scales[k];
    if (scale == 0) continue;
    Finding& finding = findings[state.order[k]];
    const auto cut = [&](const ImageView& image, View& view) {
      cut_patch(image, view.region, frame_patch(view.shape, parameters_.patch, scale, width, height), view.patch);
    };
    cut(input.left, finding.left);
    cut(input.right, finding.right);
  }
}

}  // namespace markservo::mark_detector
