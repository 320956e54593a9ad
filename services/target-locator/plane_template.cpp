#include "services/target-locator/plane_template.hpp"

#include <algorithm>
#include <cmath>

#include "services/target-locator/plane_kernel.hpp"

namespace markservo::target_locator {
namespace {

// Every how many of `mask`'s pixels leave at most `limit`.
int step_for(const Mask& mask, int limit) {
  const auto count = static_cast<int>(std::count(mask.data.begin(), mask.data.end(), 1));
  return std::max(1, (count + limit - 1) / std::max(1, limit));
}

}  // namespace

PlaneTemplate make_template(const StereoPatch& patch, const Mask& mask, int limit) {
  PlaneTemplate t;
  const int step = step_for(mask, limit);
  const PatchFrame& frame = patch.left_frame;
  std::vector<int> columns;
  const std::size_t room = mask.data.size() / static_cast<std::size_t>(step) + 1;
  columns.reserve(room);
  t.row.reserve(room);
  int skip = 0;
  for (int y = 0; y < mask.height; ++y) {
    const unsigned char* inside = mask.row(y);
    for (int x = 1; x + 1 < mask.width; ++x) {
      if (inside[x] == 0) continue;
      if (skip-- > 0) continue;
      skip = step - 1;
      columns.push_back(x);
      t.row.push_back(y);
    }
  }
  const std::size_t count = columns.size();
  if (count == 0) return t;
  double sum_x = 0.0;
  double sum_y = 0.0;
  double sum_squares = 0.0;
  double sum_grey = 0.0;
  t.count = count;
  const std::size_t padded = (count + PlaneTemplate::kLanes - 1) / PlaneTemplate::kLanes * PlaneTemplate::kLanes;
  for (auto* values :
       {&t.column, &t.grey, &t.gradient_u, &t.gradient_v, &t.slope_u, &t.along_u, &t.along_v, &t.weight}) {
    values->resize(padded);
  }
  t.row.resize(padded);
  std::fill_n(t.weight.begin(), count, 1.0F);
  const auto inverse_scale = static_cast<float>(1.0 / frame.scale);
  for (std::size_t i = 0; i < count; ++i) {
    const int x = columns[i];
    const int y = t.row[i];
    const float* grey = patch.left.row(y) + x;
    t.column[i] = static_cast<float>(x);
    t.grey[i] = grey[0];
    t.gradient_u[i] = patch.left_gradients.column.at(x, y) * inverse_scale;
    t.gradient_v[i] = patch.left_gradients.row.at(x, y) * inverse_scale;
    t.slope_u[i] = 0.5F * (grey[1] - grey[-1]) * inverse_scale;
    sum_x += x;
    sum_y += y;
    sum_squares += static_cast<double>(x) * x + static_cast<double>(y) * y;
    sum_grey += static_cast<double>(grey[0]);
  }
  const auto n = static_cast<double>(count);
  const double cx = sum_x / n;
  const double cy = sum_y / n;
  const double spread = std::sqrt(std::max(1.0, sum_squares / n - cx * cx - cy * cy));
  t.extent = spread * frame.scale;
  t.u0 = frame.u_of(cx);
  t.v0 = frame.v_of(cy);
  // About its mean, so that gain and offset do not fight each other.
  const auto mean_grey = static_cast<float>(sum_grey / n);
  const auto middle_x = static_cast<float>(cx);
  const auto middle_y = static_cast<float>(cy);
  const auto unit = static_cast<float>(1.0 / spread);
  for (std::size_t i = 0; i < count; ++i) {
    t.grey[i] -= mean_grey;
    t.along_u[i] = (t.column[i] - middle_x) * unit;
    t.along_v[i] = (static_cast<float>(t.row[i]) - middle_y) * unit;
  }
  return t;
}

void warp(const StereoPatch& patch, const PlaneTemplate& pixels, const DisparityPlane& plane,
          std::vector<float>& warped) {
  // column_right = (u_left - disparity - x_right + 0.5) / scale_right - 0.5, with u_left linear in the left column.
  const PatchFrame& right = patch.right_frame;
  const auto base = static_cast<float>(right.column_of(patch.left_frame.u_of(0.0) - plane.at(pixels.u0, pixels.v0)));
  const auto per_column = static_cast<float>(patch.left_frame.scale / right.scale);
  const auto per_u = static_cast<float>(-plane.along_u * pixels.extent / right.scale);
  const auto per_v = static_cast<float>(-plane.along_v * pixels.extent / right.scale);
  warped.resize(pixels.padded());
  sample_rows(patch.right_rows.row(0), patch.right_rows.width, pixels, {base, per_column, per_u, per_v}, warped.data());
}

double correlation_of(const PlaneTemplate& t, const std::vector<float>& warped) {
  double n = 0.0;
  double a = 0.0;
  double b = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  double ab = 0.0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t.weight[i] == 0.0F) continue;
    const auto l = static_cast<double>(t.grey[i]);
    const auto r = static_cast<double>(warped[i]);
    n += 1.0;
    a += l;
    b += r;
    aa += l * l;
    bb += r * r;
    ab += l * r;
  }
  if (n < 2.0) return 0.0;
  const double variance = (aa - a * a / n) * (bb - b * b / n);
  return variance > 0.0 ? (ab - a * b / n) / std::sqrt(variance) : 0.0;
}

}  // namespace markservo::target_locator
