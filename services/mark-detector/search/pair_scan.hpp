#pragma once

// Searches the images of one frame for marks' colours.

#include <array>
#include <bitset>
#include <cstddef>
#include <vector>

#include "common/imaging/bit_mask.hpp"
#include "common/robot/robot_description.hpp"
#include "services/mark-detector/blobs/shape.hpp"
#include "services/mark-detector/colour/frame_rule.hpp"
#include "services/mark-detector/image_view.hpp"
#include "services/mark-detector/search/colour_scan.hpp"
#include "services/mark-detector/search/search_schedule.hpp"

namespace markservo::mark_detector {

using MarkSet = std::bitset<robot::kMaxMarks>;

// The pixels of each mark's colour, as far as they were searched; of the images' size.
struct PairMasks {
  std::array<imaging::BitMask, robot::kMaxMarks> left;
  std::array<imaging::BitMask, robot::kMaxMarks> right;

  // Clears all pixels. Memory is kept.
  void reset(std::size_t num_marks, int width, int height);
};

// Where a mark was looked for.
struct PairWindow {
  ScanWindow left;
  ScanWindow right;
};

class PairScan {
 public:
  // `right` may be empty. One rule a mark. Refers to all of them; `masks` receives what is found.
  PairScan(const ImageView& left, const ImageView& right, const LumaShift& shift, const std::vector<FrameRule>& rules,
           PairMasks& masks)
      : left_(left), right_(right), shift_(shift), rules_(rules), masks_(masks) {}

  void search_everywhere(MarkSet marks) const;

  // Those of `marks` of which a few rows show something; the masks stay clear. There must be a right image.
  MarkSet in_sight(MarkSet marks, int first_row, const SearchParameters& parameters) const;

  // Looks around a mark's last shapes. There must be a right image.
  PairWindow search_around(std::size_t mark, const Shape& last_left, const Shape& last_right, int margin) const;

 private:
  const ImageView& left_;
  const ImageView& right_;
  const LumaShift& shift_;
  const std::vector<FrameRule>& rules_;
  PairMasks& masks_;
};

}  // namespace markservo::mark_detector
