#include "services/target-locator/plane/shared_visibility.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::target_locator {

void seen_by_both(const Mask& left, const PatchFrame& left_frame, const Mask& right, const PatchFrame& right_frame,
                  const DisparityPlane& plane, Mask& both) {
  both.reset(left.width(), left.height());
  // Columns of the right view are linear in the left one's.
  const double step = (1.0 - plane.along_u) * left_frame.scale / right_frame.scale;
  if (!(step > 0.0)) return;
  for (int y = left.next_used(0); y < left.height(); y = left.next_used(y + 1)) {
    const double v = left_frame.v_of(y);
    const double row = std::round(right_frame.row_of(v));
    if (!(row >= 0.0 && row < right.height())) continue;
    const int right_row = static_cast<int>(row);
    const double first = right_frame.column_of(left_frame.u_of(0.0) - plane.at(left_frame.u_of(0.0), v));
    const auto left_column = [&](int right_column) {
      const double column = std::ceil((right_column - 0.5 - first) / step);
      return static_cast<int>(std::clamp(column, 0.0, static_cast<double>(left.width())));
    };
    for (int begin = right.next(right_row, 0, true); begin < right.width();) {
      const int end = right.next(right_row, begin, false);
      if (left_column(begin) < left_column(end)) both.set_run(y, left_column(begin), left_column(end));
      begin = right.next(right_row, end, true);
    }
    std::uint64_t* out = both.row(y);
    for (int i = 0; i < both.words_per_row(); ++i) out[i] &= left.row(y)[i];
  }
}

void keep_within(const Mask& mask, std::vector<Feature>& features) {
  const auto outside = [&mask](const Feature& feature) { return !mask.test(feature.column, feature.row); };
  features.erase(std::remove_if(features.begin(), features.end(), outside), features.end());
}

}  // namespace markservo::target_locator
