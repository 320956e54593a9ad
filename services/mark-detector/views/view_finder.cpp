#include "services/mark-detector/views/view_finder.hpp"

#include <algorithm>

#include "services/mark-detector/views/separability.hpp"
#include "services/mark-detector/views/unseen_reason.hpp"

namespace markservo::mark_detector {
namespace {

// Not one flat piece: everything of its colour is the mark.
Selection select_all(const std::vector<Blob>& left, const std::vector<Blob>& right) {
  Selection selection;
  if (!left.empty()) selection.left = 0;
  if (!right.empty()) selection.right = 0;
  return selection;
}

SelectionContext context_of(const Input& input, const robot::MarkDescription& mark) {
  SelectionContext context;
  context.image_width = input.left.width;
  context.image_height = input.left.height;
  if (input.stereo) {
    context.principal_offset = input.stereo->cx_left - input.stereo->cx_right;
    if (mark.size > 0.0) context.size_per_baseline = mark.size / input.stereo->baseline;
  }
  return context;
}

}  // namespace

void ViewFinder::find(const Input& input, const robot::MarkDescription& mark, const BitMask& left_mask,
                      const BitMask& right_mask, const std::optional<PairPlace>& last, const ViewParameters& parameters,
                      Finding& finding) {
  find_blobs(left_mask, parameters, finding.left_blobs);
  find_blobs(right_mask, parameters, finding.right_blobs);
  const std::vector<Blob>& left = finding.left_blobs.blobs;
  const std::vector<Blob>& right = finding.right_blobs.blobs;
  const Selection selection = mark.surface == robot::MarkSurface::kFree
                                  ? select_all(left, right)
                                  : select_pair(left, right, context_of(input, mark), last, parameters.selection);
  finding.reason = selection.reason;
  make_view(input.left, mark.surface, finding.left_blobs, selection.left, parameters, finding.left);
  make_view(input.right, mark.surface, finding.right_blobs, selection.right, parameters, finding.right);
  const bool complete = finding.left.seen && (input.single() || finding.right.seen);
  if (!complete && finding.reason.empty()) finding.reason = why_unseen(finding, parameters.min_area, input.single());
}

void ViewFinder::find_blobs(const BitMask& mask, const ViewParameters& parameters, BlobList& list) {
  BlobParameters blobs;
  blobs.min_area = parameters.min_area;
  filter_.apply(mask, clean_);
  finder_.find(clean_, blobs, list);
}

// `chosen`: a blob of the list, or none.
void ViewFinder::make_view(const ImageView& image, robot::MarkSurface surface, const BlobList& list,
                           const std::optional<std::size_t>& chosen, const ViewParameters& parameters, View& view) {
  view.seen = chosen.has_value();
  view.clipped = false;
  view.shape = {};
  RunSpan runs;
  if (chosen) {
    const Blob& blob = list.blobs[*chosen];
    const bool one_piece = surface != robot::MarkSurface::kFree;
    runs = list.runs_of(blob);
    double area = blob.shape.area;
    if (!one_piece) {
      merge(list, merged_);
      runs = merged_;
      area = shape_of(runs).area;
    }
    const auto fraction = static_cast<std::int64_t>(parameters.hole_fraction * area);
    filler_.fill(runs, one_piece ? std::max(parameters.noise_hole, fraction) : parameters.noise_hole, filled_);
    runs = filled_;
    view.shape = shape_of(runs);
    view.clipped = is_clipped(view.shape, image.width, image.height);
  }
  make_region(runs, view.shape, SeparabilityMeter::margin(view.shape), image.width, image.height, view.region);
}

}  // namespace markservo::mark_detector
