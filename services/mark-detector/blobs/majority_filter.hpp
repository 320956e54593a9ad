#pragma once

// Cleans masks of noise.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "common/imaging/bit_mask.hpp"

namespace markservo::mark_detector {

using imaging::BitMask;

// 3 x 3 majority: a pixel is set if at least 5 of the 9 around it are; outside the image the border repeats. Takes away
// lone pixels and fills single holes, and leaves straight edges where they are. Keeps its memory from mask to mask.
class MajorityFilter {
 public:
  void apply(const BitMask& mask, BitMask& result);

 private:
  // The sum of a pixel and its neighbours left and right, 0..3, as two bit planes.
  struct RowSum {
    std::vector<std::uint64_t> ones;
    std::vector<std::uint64_t> twos;
    int begin = 0;  // words that may not be zero
    int end = 0;
  };

  static void sum_row(const BitMask& mask, int v, RowSum& sum);
  static std::uint64_t majority_of_nine(const RowSum& above, const RowSum& here, const RowSum& below, std::size_t i);

  RowSum sums_[3];
};

}  // namespace markservo::mark_detector
