#include "services/mark-detector/mark_detector.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "services/mark-detector/bit_mask.hpp"
#include "services/mark-detector/colour_kernel.hpp"
#include "services/mark-detector/luma_equalisation.hpp"
#include "services/mark-detector/outline_kernel.hpp"
#include "services/mark-detector/separability.hpp"

namespace markservo::mark_detector {
namespace {

void check(bool condition, const std::string& what) {
  if (!condition) throw std::invalid_argument("MarkDetector: " + what);
}

// Why one image shows no blob of the mark.
std::string why_not(const BlobList& blobs, int64_t min_area, const char* where) {
  if (blobs.largest_area == 0) return std::string("no pixel of its colour in ") + where;
  return std::string("largest blob in ") + where + " has " + std::to_string(blobs.largest_area) + " px, fewer than " +
         std::to_string(min_area);
}

std::string why_unseen(const Finding& finding, int64_t min_area, bool single) {
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
std::vector<std::size_t> by_importance(const std::vector<Finding>& findings, int width, int height) {
  std::vector<std::size_t> order;
  LastSeen focus{0.5 * (width - 1), 0.5 * (height - 1), 0.5 * (width - 1)};
  for (std::size_t i = 0; i < findings.size(); ++i) {
    const Finding& finding = findings[i];
    if (!finding.left.seen || !finding.right.seen) continue;
    order.push_back(i);
    if (finding.role == robot::MarkRole::kManipulator) focus = place_of(finding);
  }
  const auto rank = [&](std::size_t i) {
    const bool hand = findings[i].role == robot::MarkRole::kManipulator;
    return std::make_pair(hand ? 0 : 1, distance_2(place_of(findings[i]), focus));
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return rank(a) < rank(b); });
  return order;
}

}  // namespace

MarkDetector::MarkDetector(std::vector<robot::MarkDescription> marks, const Parameters& parameters)
    : marks_(std::move(marks)), parameters_(parameters) {
  check(!marks_.empty() && marks_.size() <= robot::kMaxMarks,
        std::to_string(marks_.size()) + " marks; allowed: 1 to " + std::to_string(robot::kMaxMarks));
  check(parameters_.histogram_rows >= 1, "histogram_rows below 1");
  check(parameters_.min_area >= 1, "min_area below 1 px");
  check(parameters_.patch.limit >= 1, "patch limit below 1 px");
  check(parameters_.patch.margin >= 0, "patch margin below 0 px");
  check(parameters_.outline.band >= 1 && parameters_.outline.reach > 2 * parameters_.outline.band,
        "outline reach not above twice the band");
  check(2 * parameters_.outline.reach + 1 <= ColumnSums::kMaxRows, "outline reach above 63 px");
  rules_.reserve(marks_.size());
  for (const auto& mark : marks_) rules_.push_back(make_rule(mark.colour, parameters_.chroma_min));
}

Output MarkDetector::step(const Input& input, State& state) const {
  check(!input.left.empty(), "the left image is empty");
  const bool single = input.right.empty();
  check(single || (input.right.width == input.left.width && input.right.height == input.left.height),
        "the images' sizes differ");

  LumaShift shift = no_shift();
  if (parameters_.equalise) {
    // One table for both images, so that a mark is judged alike in both.
    LumaHistogram histogram{};
    const int step = std::max(1, input.left.height / parameters_.histogram_rows);
    accumulate(input.left, histogram, step);
    if (!single) accumulate(input.right, histogram, step);
    shift = against_darkness(equalising_shift(histogram));
  }
  const std::vector<FrameRule> rules = frame_rules(rules_, shift);
  classify(input.left, shift, rules, state.left_masks);
  if (!single) classify(input.right, shift, rules, state.right_masks);

  BlobParameters blobs;
  blobs.min_area = parameters_.min_area;
  Output output;
  for (std::size_t i = 0; i < marks_.size(); ++i) {
    Finding finding;
    finding.name = marks_[i].name;
    finding.role = marks_[i].role;
    finding.left_blobs = find_blobs(majority3(state.left_masks[i]), blobs);
    if (!single) finding.right_blobs = find_blobs(majority3(state.right_masks[i]), blobs);
    find_views(input, state, marks_[i], finding);
    output.marks.push_back(std::move(finding));
  }
  cut_patches(input, output.marks);
  return output;
}

void MarkDetector::find_views(const Input& input, State& state, const robot::MarkDescription& mark,
                              Finding& finding) const {
  const bool single = input.right.empty();
  const std::vector<Blob>& left = finding.left_blobs.blobs;
  const std::vector<Blob>& right = finding.right_blobs.blobs;
  auto memory = state.marks.find(mark.name);
  if (memory != state.marks.end() && ++memory->second.age > parameters_.memory_frames) {
    state.marks.erase(memory);
    memory = state.marks.end();
  }

  if (mark.surface == robot::MarkSurface::kFree) {
    // Not one flat piece: everything of its colour is the mark.
    if (!left.empty()) finding.left = make_view(input.left, mark, merge(left));
    if (!right.empty()) finding.right = make_view(input.right, mark, merge(right));
  } else {
    SelectionContext context;
    context.image_width = input.left.width;
    context.image_height = input.left.height;
    if (input.stereo) {
      context.principal_offset = input.stereo->cx_left - input.stereo->cx_right;
      if (mark.size > 0.0) context.size_per_baseline = mark.size / input.stereo->baseline;
    }
    const auto last = memory == state.marks.end() ? std::nullopt : std::make_optional(memory->second.place);
    const Selection selection = select_pair(left, right, context, last, parameters_.selection);
    if (selection.left) finding.left = make_view(input.left, mark, left[*selection.left]);
    if (selection.right) finding.right = make_view(input.right, mark, right[*selection.right]);
    finding.reason = selection.reason;
  }
  const bool complete = finding.left.seen && (single || finding.right.seen);
  if (!complete && finding.reason.empty()) finding.reason = why_unseen(finding, parameters_.min_area, single);
  if (complete && !single) state.marks[mark.name] = {place_of(finding), 0};

  if (finding.left.seen) finding.separability = separability(input.left, finding.left.region);
  if (finding.right.seen) {
    const double of_right = separability(input.right, finding.right.region);
    finding.separability = finding.left.seen ? std::min(finding.separability, of_right) : of_right;
  }
}

View MarkDetector::make_view(const ImageView& image, const robot::MarkDescription& mark, const Blob& blob) const {
  View view;
  const bool plane = mark.surface == robot::MarkSurface::kPlane;
  const auto fraction = static_cast<int64_t>(parameters_.hole_fraction * blob.shape.area);
  const std::vector<PixelRun> runs =
      fill_holes(blob, plane ? std::max(parameters_.noise_hole, fraction) : parameters_.noise_hole);
  OutlinedMark outlined =
      plane ? outline(image, runs, parameters_.outline) : hard_outline(runs, image.width, image.height);
  view.seen = true;
  view.shape = outlined.shape;
  view.region = std::move(outlined.region);
  view.clipped = is_clipped(view.shape, image.width, image.height);
  return view;
}

void MarkDetector::cut_patches(const Input& input, std::vector<Finding>& findings) const {
  if (input.right.empty()) return;
  const int width = input.left.width;
  const int height = input.left.height;
  const std::vector<std::size_t> order = by_importance(findings, width, height);
  std::vector<PatchRequest> requests;
  requests.reserve(order.size());
  for (const std::size_t i : order) requests.push_back({findings[i].left.shape, findings[i].right.shape});
  const std::vector<int> scales = plan_scales(requests, parameters_.patch, width, height);
  for (std::size_t k = 0; k < order.size(); ++k) {
    if (scales[k] == 0) continue;
    Finding& finding = findings[order[k]];
    const auto cut = [&](const ImageView& image, View& view) {
      const PatchFrame frame = frame_patch(view.shape, parameters_.patch, scales[k], width, height);
      view.patch = cut_patch(image, view.region, frame);
    };
    cut(input.left, finding.left);
    cut(input.right, finding.right);
  }
}

}  // namespace markservo::mark_detector
