#include "services/target-locator/plane_alignment.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <vector>

#include "services/target-locator/epipolar_rows.hpp"

namespace markservo::target_locator {
namespace {

// Parameters of right(u - disparity) = gain left + offset + rising d left / dv: disparity at the centre, along u, along
// v (both per half extent of the mark), gain, offset, and how much higher the right view lies than the rows say.
constexpr int kNumParameters = 6;
using Vector6 = Eigen::Matrix<double, kNumParameters, 1>;
using Matrix6 = Eigen::Matrix<double, kNumParameters, kNumParameters>;

// The masked left pixels, in reading order.
struct Template {
  std::vector<float> column;   // patch px
  std::vector<int> row;        // patch px
  std::vector<float> along_u;  // from the centre, in half extents
  std::vector<float> along_v;
  std::vector<float> grey;
  std::vector<float> gradient_u;  // Sobel's, per image px
  std::vector<float> gradient_v;
  std::vector<float> slope_u;  // plain central difference, per image px
  std::vector<unsigned char> used;
  double u0 = 0.0;
  double v0 = 0.0;
  double extent = 1.0;  // image px

  std::size_t size() const { return column.size(); }
};

// Of the masked pixels every `step`-th, in reading order.
Template make_template(const StereoPatch& patch, const Mask& mask, int step) {
  Template t;
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
  for (auto* values : {&t.column, &t.grey, &t.gradient_u, &t.gradient_v, &t.slope_u, &t.along_u, &t.along_v}) {
    values->resize(count);
  }
  t.used.assign(count, 1);
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

// Every how many of `mask`'s pixels leave at most `limit`.
int step_for(const Mask& mask, int limit) {
  const auto count = static_cast<int>(std::count(mask.data.begin(), mask.data.end(), 1));
  return std::max(1, (count + limit - 1) / std::max(1, limit));
}

// The right view's grey value at every template pixel, for the disparity plane given by `p`.
void warp(const StereoPatch& patch, const Template& t, const PlaneImage& right_rows, const Vector6& p,
          std::vector<float>& warped) {
  // column_right = (u_left - disparity - x_right + 0.5) / scale_right - 0.5, with u_left linear in the left column.
  const double ratio = patch.left_frame.scale / patch.right_frame.scale;
  const auto base = static_cast<float>(patch.right_frame.column_of(patch.left_frame.u_of(0.0) - p[0]));
  const auto per_column = static_cast<float>(ratio);
  const auto per_u = static_cast<float>(-p[1] / patch.right_frame.scale);
  const auto per_v = static_cast<float>(-p[2] / patch.right_frame.scale);
  warped.resize(t.size());
  for (std::size_t i = 0; i < t.size(); ++i) {
    const float x = base + per_column * t.column[i] + per_u * t.along_u[i] + per_v * t.along_v[i];
    warped[i] = sample_cubic(right_rows.row(t.row[i]), right_rows.width, x);
  }
}

struct NormalMatrices {
  Matrix6 newton = Matrix6::Zero();       // derivative of the normal equations
  Matrix6 information = Matrix6::Zero();  // of their noise, times the residuals' variance
  double count = 0.0;
};

// Left factor Sobel's gradient (little noise), right factor the plain difference (the texture's true slope). They
// differ in the three rows of the plane only.
NormalMatrices normal_matrices(const Template& t) {
  NormalMatrices sums;
  Eigen::Matrix<float, 6, 6> information = Eigen::Matrix<float, 6, 6>::Zero();
  Eigen::Matrix<float, 6, 3> cross = Eigen::Matrix<float, 6, 3>::Zero();
  std::size_t in_block = 0;
  const auto flush = [&] {
    sums.information += information.cast<double>();
    sums.newton.leftCols<3>() += cross.cast<double>();
    information.setZero();
    cross.setZero();
    in_block = 0;
  };
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t.used[i] == 0) continue;
    const float gu = t.gradient_u[i];
    const float su = t.slope_u[i];
    const float left[6] = {-gu, -gu * t.along_u[i], -gu * t.along_v[i], -t.grey[i], -1.0F, -t.gradient_v[i]};
    const float right[3] = {-su, -su * t.along_u[i], -su * t.along_v[i]};
    for (int column = 0; column < 6; ++column) {
      for (int row = 0; row < 6; ++row) information(row, column) += left[row] * left[column];
    }
    for (int column = 0; column < 3; ++column) {
      for (int row = 0; row < 6; ++row) cross(row, column) += left[row] * right[column];
    }
    sums.count += 1.0;
    if (++in_block == 256) flush();
  }
  flush();
  sums.newton.rightCols<3>() = sums.information.rightCols<3>();
  return sums;
}

struct Residuals {
  Vector6 right_side = Vector6::Zero();
  double sum_of_squares = 0.0;
};

Residuals residuals(const Template& t, const std::vector<float>& warped, const Vector6& p,
                    std::vector<float>& residual) {
  Residuals sums;
  residual.resize(t.size());
  const auto gain = static_cast<float>(p[3]);
  const auto offset = static_cast<float>(p[4]);
  const auto rising = static_cast<float>(p[5]);
  float block[kNumParameters] = {};
  float squares = 0.0F;
  std::size_t in_block = 0;
  const auto flush = [&] {
    for (int k = 0; k < kNumParameters; ++k) {
      sums.right_side[k] += static_cast<double>(block[k]);
      block[k] = 0.0F;
    }
    sums.sum_of_squares += static_cast<double>(squares);
    squares = 0.0F;
    in_block = 0;
  };
  for (std::size_t i = 0; i < t.size(); ++i) {
    const float r = warped[i] - gain * t.grey[i] - offset - rising * t.gradient_v[i];
    residual[i] = r;
    if (t.used[i] == 0) continue;
    const float gr = t.gradient_u[i] * r;
    block[0] -= gr;
    block[1] -= gr * t.along_u[i];
    block[2] -= gr * t.along_v[i];
    block[3] -= t.grey[i] * r;
    block[4] -= r;
    block[5] -= t.gradient_v[i] * r;
    squares += r * r;
    if (++in_block == 256) flush();
  }
  flush();
  return sums;
}

// Median of |residual| times 1.4826.
double robust_sigma(std::vector<float> residual) {
  for (float& r : residual) r = std::abs(r);
  const auto middle = residual.begin() + static_cast<std::ptrdiff_t>(residual.size() / 2);
  std::nth_element(residual.begin(), middle, residual.end());
  return 1.4826 * static_cast<double>(*middle);
}

double correlation_of(const Template& t, const std::vector<float>& warped) {
  double n = 0.0;
  double a = 0.0;
  double b = 0.0;
  double aa = 0.0;
  double bb = 0.0;
  double ab = 0.0;
  for (std::size_t i = 0; i < t.size(); ++i) {
    if (t.used[i] == 0) continue;
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

// Of the masked pixels, in the image: count, centroid (px) and second moments about it (px^2).
struct MaskMoments {
  double count = 0.0;
  double u = 0.0;
  double v = 0.0;
  double uu = 0.0;
  double uv = 0.0;
  double vv = 0.0;
};

MaskMoments moments_of(const Mask& mask, const PatchFrame& frame) {
  MaskMoments m;
  for (int y = 0; y < mask.height; ++y) {
    const unsigned char* line = mask.row(y);
    int count = 0;
    int first = 0;
    for (int x = 0; x < mask.width; ++x) {
      count += line[x];
      first += line[x] * x;
    }
    m.count += count;
    m.u += first;
    m.v += static_cast<double>(count) * y;
  }
  if (!(m.count > 0.0)) return m;
  const double cx = m.u / m.count;
  const double cy = m.v / m.count;
  for (int y = 0; y < mask.height; ++y) {
    const unsigned char* line = mask.row(y);
    float count = 0.0F;
    float first = 0.0F;
    float second = 0.0F;
    for (int x = 0; x < mask.width; ++x) {
      const float off = static_cast<float>(x) - static_cast<float>(cx);
      const auto inside = static_cast<float>(line[x]);
      count += inside;
      first += inside * off;
      second += inside * off * off;
    }
    const double dy = y - cy;
    m.uu += static_cast<double>(second);
    m.uv += static_cast<double>(first) * dy;
    m.vv += static_cast<double>(count) * dy * dy;
  }
  const double unit = frame.scale * frame.scale / m.count;
  m.uu *= unit;
  m.uv *= unit;
  m.vv *= unit;
  m.u = frame.u_of(cx);
  m.v = frame.v_of(cy);
  return m;
}

Vector6 parameters_of(const DisparityPlane& plane, const Template& t) {
  Vector6 p;
  p << plane.at(t.u0, t.v0), plane.along_u * t.extent, plane.along_v * t.extent, 1.0, 0.0, 0.0;
  return p;
}

DisparityPlane plane_of(const Vector6& p, const Template& t) {
  return {t.u0, t.v0, p[0], p[1] / t.extent, p[2] / t.extent};
}

// Gauss-Newton over one set of pixels.
class Fit {
 public:
  Fit(const StereoPatch& patch, const Mask& mask, int limit)
      : patch_(patch), pixels_(make_template(patch, mask, step_for(mask, limit))) {
    factorise();
  }

  const Template& pixels() const { return pixels_; }
  const Vector6& parameters() const { return p_; }
  bool solvable() const { return solvable_; }

  // From `start` until a step moves the disparities by less than `settled`. False when it diverges.
  bool iterate(const Vector6& start, int iterations, double settled, double max_change) {
    p_ = start;
    for (int k = 0; k < iterations; ++k) {
      evaluate();
      const Vector6 change = -solver_.solve(sums_.right_side);
      if (!change.allFinite()) return false;
      p_ += change;
      if (!((p_ - start).head<3>().cwiseAbs().sum() < 3.0 * max_change)) return false;
      if (change.head<3>().cwiseAbs().sum() < settled) break;
    }
    evaluate();
    return true;
  }

  // Leaves out the pixels with large residuals; returns the share that stays.
  double drop_outliers(double sigmas) {
    const double limit = std::max(2.0, sigmas * robust_sigma(residual_));
    std::size_t kept = 0;
    for (std::size_t i = 0; i < pixels_.size(); ++i) {
      pixels_.used[i] = std::abs(static_cast<double>(residual_[i])) <= limit ? 1 : 0;
      kept += pixels_.used[i];
    }
    const double share = static_cast<double>(kept) / static_cast<double>(pixels_.size());
    if (kept < pixels_.size()) factorise();
    return share;
  }

  double correlation() const { return correlation_of(pixels_, warped_); }

  std::optional<Matrix6> covariance(double noise_correlation) {
    evaluate();
    const double variance = noise_correlation * sums_.sum_of_squares / std::max(1.0, normal_.count - kNumParameters);
    const Matrix6 inverse = solver_.inverse();
    const Matrix6 covariance = variance * inverse * normal_.information * inverse.transpose();
    if (!covariance.allFinite()) return std::nullopt;
    return covariance;
  }

 private:
  void factorise() {
    normal_ = normal_matrices(pixels_);
    solvable_ = normal_.count >= 3.0 * kNumParameters;
    solver_.compute(normal_.newton);
  }
  void evaluate() {
    warp(patch_, pixels_, patch_.right_rows, p_, warped_);
    sums_ = residuals(pixels_, warped_, p_, residual_);
  }

  const StereoPatch& patch_;
  Template pixels_;
  NormalMatrices normal_;
  Eigen::PartialPivLU<Matrix6> solver_;
  bool solvable_ = false;
  Vector6 p_ = Vector6::Zero();
  std::vector<float> warped_;
  std::vector<float> residual_;
  Residuals sums_;
};

}  // namespace

std::optional<DisparityPlane> plane_of_masks(const Mask& left, const PatchFrame& left_frame, const Mask& right,
                                             const PatchFrame& right_frame) {
  const MaskMoments l = moments_of(left, left_frame);
  const MaskMoments r = moments_of(right, right_frame);
  if (!(l.count > 8.0) || !(r.count > 8.0) || !(l.vv > 0.5)) return std::nullopt;
  // u_right = (1 - along_u) u - along_v v + constant, v_right = v.
  const double left_width = l.uu - l.uv * l.uv / l.vv;
  const double right_width = r.uu - r.uv * r.uv / l.vv;
  if (!(left_width > 0.5) || !(right_width > 0.5)) return std::nullopt;
  const double stretch = std::sqrt(right_width / left_width);
  DisparityPlane plane;
  plane.u0 = l.u;
  plane.v0 = l.v;
  plane.at_centre = l.u - r.u;
  plane.along_u = 1.0 - stretch;
  plane.along_v = (stretch * l.uv - r.uv) / l.vv;
  constexpr double kSteepest = 1.0;  // px per px
  if (!(std::abs(plane.along_u) < kSteepest) || !(std::abs(plane.along_v) < kSteepest)) return std::nullopt;
  return plane;
}

PlaneSeed seed_plane(const StereoPatch& patch, const Mask& mask, const DisparityPlane& guess, double reach,
                     const AlignmentParameters& parameters) {
  const Template t = make_template(patch, mask, step_for(mask, parameters.max_seed_pixels));
  if (t.size() < 2 || patch.right_rows.width < 4) return {guess, -1.0};
  const double step = patch.right_frame.scale;
  const int steps = static_cast<int>(std::ceil(std::max(0.0, reach) / step));
  std::vector<float> warped;
  double best = -2.0;
  double best_shift = 0.0;
  Vector6 p = parameters_of(guess, t);
  const double start = p[0];
  // From the middle outwards, so that of equals the one nearest the guess wins.
  for (int k = 0; k <= 2 * steps; ++k) {
    const double shift = step * ((k % 2 == 0) ? k / 2 : -(k + 1) / 2);
    p[0] = start + shift;
    warp(patch, t, patch.right_rows, p, warped);
    const double score = correlation_of(t, warped);
    if (score > best) {
      best = score;
      best_shift = shift;
    }
  }
  PlaneSeed seed{guess, best};
  seed.plane.at_centre += best_shift;
  return seed;
}

std::optional<PlaneAlignment> align_plane(const StereoPatch& patch, const Mask& mask, const DisparityPlane& seed,
                                          const AlignmentParameters& parameters) {
  if (patch.right_rows.width < 4) return std::nullopt;
  Fit rough(patch, mask, parameters.max_rough_pixels);
  if (!rough.solvable()) return std::nullopt;
  const Vector6 start = parameters_of(seed, rough.pixels());
  if (!rough.iterate(start, parameters.max_iterations, parameters.rough_px, parameters.max_seed_error_px)) {
    return std::nullopt;
  }
  Fit fit(patch, mask, parameters.max_pixels);
  const DisparityPlane close = plane_of(rough.parameters(), rough.pixels());
  const auto iterate = [&](const Vector6& from) {
    return fit.iterate(from, parameters.max_final_iterations, parameters.settled_px, parameters.max_seed_error_px);
  };
  if (!fit.solvable() || !iterate(parameters_of(close, fit.pixels()))) return std::nullopt;
  const double share = fit.drop_outliers(parameters.outlier_sigmas);
  constexpr double kHardlyAny = 0.995;  // noise alone exceeds 3.5 sigmas now and then
  if (share < kHardlyAny && (!fit.solvable() || !iterate(fit.parameters()))) return std::nullopt;
  const auto covariance = fit.covariance(parameters.noise_correlation);
  if (!covariance) return std::nullopt;

  PlaneAlignment result;
  result.plane = plane_of(fit.parameters(), fit.pixels());
  if (std::abs(result.plane.at_centre - seed.at(result.plane.u0, result.plane.v0)) > parameters.max_seed_error_px) {
    return std::nullopt;
  }
  const double extent = fit.pixels().extent;
  const Eigen::DiagonalMatrix<double, 3> unit(1.0, 1.0 / extent, 1.0 / extent);
  result.covariance = unit * covariance->topLeftCorner<3, 3>() * unit;
  result.covariance(0, 0) += parameters.disparity_floor_px * parameters.disparity_floor_px;
  result.row_offset = -fit.parameters()[5];
  result.correlation = fit.correlation();
  result.inlier_share = share;
  return result;
}

}  // namespace markservo::target_locator
