#pragma once

// From the pixels of a mark's colour to the mark in both images.

#include <cstdint>
#include <optional>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/blobs/blobs.hpp"
#include "services/mark-detector/blobs/hole_filler.hpp"
#include "services/mark-detector/blobs/majority_filter.hpp"
#include "services/mark-detector/detector_input.hpp"
#include "services/mark-detector/detector_output.hpp"
#include "services/mark-detector/views/mark_selection.hpp"

namespace markservo::mark_detector {

struct ViewParameters {
  std::int64_t min_area = 60;   // px; a mark of 8 x 8 px has no texture to match
  double hole_fraction = 0.1;   // of the blob's area: holes up to this are dirt, glare or print, and belong to the mark
  std::int64_t noise_hole = 9;  // px; holes up to this are noise, also in marks that are free
  SelectionParameters selection;
};

// Keeps its memory from mark to mark.
class ViewFinder {
 public:
  // Cleans the masks, of the images' size, and chooses among their blobs: of a flat mark the pair that one object of
  // its size can have made, near `last` if that is known; of a free one all. Fills in the finding's blobs, reason and
  // views but for their patches. Of a single picture the right mask is empty.
  void find(const Input& input, const robot::MarkDescription& mark, const BitMask& left_mask, const BitMask& right_mask,
            const std::optional<PairPlace>& last, const ViewParameters& parameters, Finding& finding);

 private:
  void find_blobs(const BitMask& mask, const ViewParameters& parameters, BlobList& list);
  void make_view(const ImageView& image, robot::MarkSurface surface, const BlobList& list,
                 const std::optional<std::size_t>& chosen, const ViewParameters& parameters, View& view);

  MajorityFilter filter_;
  BitMask clean_;
  BlobFinder finder_;
  HoleFiller filler_;
  std::vector<PixelRun> merged_;
  std::vector<PixelRun> filled_;
};

}  // namespace markservo::mark_detector
