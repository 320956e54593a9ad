#include "services/target-locator/square_outline.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>
#include <cstdint>
#include <vector>

namespace markservo::target_locator {
namespace {

constexpr double kPi = 3.14159265358979323846;

// A side as across = p + q * (along - middle): `along` is the row of an upright side, the column of a lying one.
struct Side {
  bool upright = true;
  bool inside_after = true;  // the mark lies at larger `across`
  double middle = 0.0;
  double p = 0.0;
  double q = 0.0;
  double from = 0.0;  // along, between the corners
  double to = 0.0;
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero();  // of (p, q)
  double rms = 0.0;

  double across(double along) const { return p + q * (along - middle); }
};

// n . x = c with n not normalised.
struct Line {
  Eigen::Vector2d n;
  double c;
};

Line line_of(const Side& side, double p, double q) {
  // across - q along = p - q middle
  return side.upright ? Line{{1.0, -q}, p - q * side.middle} : Line{{-q, 1.0}, p - q * side.middle};
}

std::optional<Eigen::Vector2d> intersect(const Line& a, const Line& b) {
  const double determinant = a.n.x() * b.n.y() - a.n.y() * b.n.x();
  if (std::abs(determinant) < 1e-6) return std::nullopt;
  return Eigen::Vector2d((a.c * b.n.y() - b.c * a.n.y()) / determinant, (a.n.x() * b.c - b.n.x() * a.c) / determinant);
}

using Corners = std::array<Eigen::Vector2d, 4>;

std::optional<Corners> corners_of(const std::array<Line, 4>& lines) {
  Corners corners;
  for (std::size_t k = 0; k < 4; ++k) {
    const auto corner = intersect(lines[k], lines[(k + 1) % 4]);
    if (!corner) return std::nullopt;
    corners[k] = *corner;
  }
  return corners;
}

std::optional<Eigen::Vector2d> diagonals_meet(const Corners& c) {
  const Eigen::Vector2d a = c[2] - c[0];
  const Eigen::Vector2d b = c[3] - c[1];
  return intersect({{-a.y(), a.x()}, a.x() * c[0].y() - a.y() * c[0].x()},
                   {{-b.y(), b.x()}, b.x() * c[1].y() - b.y() * c[1].x()});
}

// The parallelogram with the mask's first, second and fourth moments: exact for a square under any affine map.
std::optional<std::array<Line, 4>> lines_from_moments(const Mask& mask, double min_squareness) {
  double n = 0.0;
  double sx = 0.0;
  double sy = 0.0;
  double sxx = 0.0;
  double sxy = 0.0;
  double syy = 0.0;
  for (int y = 0; y < mask.height; ++y) {
    const unsigned char* line = mask.row(y);
    int count = 0;
    int first = 0;
    std::int64_t second = 0;
    for (int x = 0; x < mask.width; ++x) {
      count += line[x];
      first += line[x] * x;
      second += static_cast<std::int64_t>(line[x]) * x * x;
    }
    n += count;
    sx += first;
    sy += static_cast<double>(count) * y;
    sxx += static_cast<double>(second);
    sxy += static_cast<double>(first) * y;
    syy += static_cast<double>(count) * y * y;
  }
  if (n < 64.0) return std::nullopt;
  const Eigen::Vector2d centre(sx / n, sy / n);
  Eigen::Matrix2d moments;
  moments << sxx / n - centre.x() * centre.x(), sxy / n - centre.x() * centre.y(), sxy / n - centre.x() * centre.y(),
      syy / n - centre.y() * centre.y();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(moments);
  if (!(solver.eigenvalues()[0] > 1.0)) return std::nullopt;
  const Eigen::Matrix2d whiten = solver.operatorInverseSqrt();
  // Every other pixel of every other row is plenty for an angle.
  std::complex<double> fourth = 0.0;
  double sampled = 0.0;
  for (int y = 0; y < mask.height; y += 2) {
    const unsigned char* line = mask.row(y);
    const double dy = y - centre.y();
    for (int x = 0; x < mask.width; x += 2) {
      if (line[x] == 0) continue;
      sampled += 1.0;
      const double dx = x - centre.x();
      const double a = whiten(0, 0) * dx + whiten(0, 1) * dy;
      const double b = whiten(1, 0) * dx + whiten(1, 1) * dy;
      const double re = a * a - b * b;
      const double im = 2.0 * a * b;
      fourth += std::complex<double>(re * re - im * im, 2.0 * re * im);
    }
  }
  constexpr double kSquare = 2.4;  // |mean of (x + iy)^4| of a square with unit second moments
  if (!(sampled > 0.0) || std::abs(fourth) / sampled < kSquare * min_squareness) return std::nullopt;
  const double turn = std::arg(-fourth) / 4.0;
  std::array<Line, 4> lines;
  for (std::size_t k = 0; k < 4; ++k) {
    const double angle = turn + 0.5 * kPi * static_cast<double>(k);
    const Eigen::Vector2d normal = whiten * Eigen::Vector2d(std::cos(angle), std::sin(angle));
    lines[k] = {normal, std::sqrt(3.0) + normal.dot(centre)};
  }
  return lines;
}

Side side_of(const Line& line, const Eigen::Vector2d& a, const Eigen::Vector2d& b, double corner_share) {
  Side side;
  side.upright = std::abs(line.n.x()) >= std::abs(line.n.y());
  const double across = side.upright ? line.n.x() : line.n.y();
  const double along = side.upright ? line.n.y() : line.n.x();
  side.inside_after = across < 0.0;  // the normal points outwards
  const double start = side.upright ? std::min(a.y(), b.y()) : std::min(a.x(), b.x());
  const double end = side.upright ? std::max(a.y(), b.y()) : std::max(a.x(), b.x());
  const double cut = corner_share * (end - start);
  side.from = start + cut;
  side.to = end - cut;
  side.middle = 0.5 * (start + end);
  side.q = -along / across;
  side.p = line.c / across + side.q * side.middle;
  return side;
}

struct EdgePoint {
  double along;
  double across;
};

// Neighbouring points share texture: how many of them count as one, from the correlation of their residuals.
double points_per_independent_one(const std::vector<double>& residual, double tolerance) {
  constexpr std::size_t kLongestLag = 8;
  double squares = 0.0;
  double products = 0.0;
  for (std::size_t i = 0; i < residual.size(); ++i) {
    if (std::abs(residual[i]) > tolerance) continue;
    squares += residual[i] * residual[i];
    for (std::size_t lag = 1; lag <= kLongestLag && i + lag < residual.size(); ++lag) {
      if (std::abs(residual[i + lag]) <= tolerance) products += residual[i] * residual[i + lag];
    }
  }
  // Fitting the line takes its share of the correlation away, so that even independent points count as two.
  return squares > 0.0 ? std::clamp(2.0 + 2.0 * products / squares, 2.0, 10.0) : 2.0;
}

// Robust line through the points; false when too few lie on it.
bool fit_line(const std::vector<EdgePoint>& points, std::size_t wanted, double tolerance_floor,
              const OutlineParameters& parameters, Side& side) {
  if (points.size() < 6) return false;
  constexpr int kPasses = 5;
  std::vector<double> residual(points.size());
  std::vector<double> size(points.size());
  double tolerance = 1e9;
  std::size_t good = 0;
  for (int pass = 0; pass < kPasses; ++pass) {
    double n = 0.0;
    double st = 0.0;
    double sz = 0.0;
    double stt = 0.0;
    double stz = 0.0;
    good = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double t = points[i].along - side.middle;
      if (pass > 0 && std::abs(residual[i]) > tolerance) continue;
      ++good;
      n += 1.0;
      st += t;
      sz += points[i].across;
      stt += t * t;
      stz += t * points[i].across;
    }
    const double determinant = n * stt - st * st;
    if (good < 6 || !(determinant > 1e-9)) return false;
    side.q = (n * stz - st * sz) / determinant;
    side.p = (stt * sz - st * stz) / determinant;
    double squares = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double before = residual[i];
      residual[i] = points[i].across - side.across(points[i].along);
      size[i] = std::abs(residual[i]);
      if (pass == 0 || std::abs(before) <= tolerance) squares += residual[i] * residual[i];
    }
    const auto middle = size.begin() + static_cast<std::ptrdiff_t>(size.size() / 2);
    std::nth_element(size.begin(), middle, size.end());
    const double next = std::max(tolerance_floor, 3.0 * 1.4826 * *middle);
    const bool all_agree = good == points.size() && *std::max_element(size.begin(), size.end()) <= next;
    if (all_agree || pass + 1 == kPasses) {
      const double variance = points_per_independent_one(residual, tolerance) * squares / std::max(1.0, n - 2.0);
      side.rms = std::sqrt(squares / n);
      side.covariance << stt, -st, -st, n;
      side.covariance *= variance / determinant;
      break;
    }
    tolerance = next;
  }
  return static_cast<double>(good) >= parameters.min_good_share * static_cast<double>(wanted);
}

int rows_of(const Side& side, int& first) {
  first = static_cast<int>(std::ceil(side.from));
  return static_cast<int>(std::floor(side.to)) - first + 1;
}

// Where the mask begins near the side, to half a pixel.
bool fit_to_mask(const Mask& mask, const OutlineParameters& parameters, Side& side) {
  constexpr int kReach = 6;
  int first = 0;
  const int count = rows_of(side, first);
  const int limit_along = side.upright ? mask.height : mask.width;
  const int limit_across = side.upright ? mask.width : mask.height;
  const auto at = [&](int along, int across) {
    if (across < 0 || across >= limit_across) return 0;
    return static_cast<int>(side.upright ? mask.at(across, along) : mask.at(along, across));
  };
  std::vector<EdgePoint> points;
  for (int k = 0; k < count; ++k) {
    const int along = first + k;
    if (along < 0 || along >= limit_along) continue;
    const int start = static_cast<int>(std::lround(side.across(along)));
    const int step = side.inside_after ? 1 : -1;
    // From outside inwards: the first mask pixel that the next two agree with.
    for (int d = -kReach; d <= kReach; ++d) {
      const int here = start + step * d;
      if (at(along, here) != 0 && at(along, here + step) != 0 && at(along, here + 2 * step) != 0) {
        if (d > -kReach) points.push_back({static_cast<double>(along), here - 0.5 * step});
        break;
      }
    }
  }
  return fit_line(points, static_cast<std::size_t>(std::max(count, 6)), 0.8, parameters, side);
}

// Where the contrast's step lies, by its area within two and a half pixels of the line, row by row.
constexpr int kLevelFrom = 3;  // px from the line, beyond its blur
constexpr int kLevelTo = 5;
bool fit_to_contrast(const PlaneImage& contrast, const OutlineParameters& parameters, Side& side) {
  int first = 0;
  const int count = rows_of(side, first);
  const int limit_along = side.upright ? contrast.height : contrast.width;
  const int limit_across = side.upright ? contrast.width : contrast.height;
  const std::ptrdiff_t step = side.upright ? 1 : contrast.width;
  std::vector<EdgePoint> points;
  for (int k = 0; k < count; ++k) {
    const int along = first + k;
    if (along < 0 || along >= limit_along) continue;
    const int middle = static_cast<int>(std::lround(side.across(along)));
    // The margin around the mark may be as little as three pixels; levels come from what there is.
    const int reach_before = std::min(kLevelTo, middle);
    const int reach_after = std::min(kLevelTo, limit_across - 1 - middle);
    if (reach_before < kLevelFrom || reach_after < kLevelFrom) continue;
    const float* centre = side.upright ? contrast.row(along) + middle : contrast.row(middle) + along;
    double before = 0.0;
    double after = 0.0;
    for (int d = kLevelFrom; d <= reach_before; ++d) before += static_cast<double>(centre[-d * step]);
    for (int d = kLevelFrom; d <= reach_after; ++d) after += static_cast<double>(centre[d * step]);
    before /= reach_before - kLevelFrom + 1;
    after /= reach_after - kLevelFrom + 1;
    const double span = side.inside_after ? after - before : before - after;
    if (span < parameters.min_span) continue;
    double sum = 0.0;
    for (int d = -2; d <= 2; ++d) sum += static_cast<double>(centre[d * step]);
    // Of the five pixels, this many lie on the `after` side of the step.
    const double share = (sum - 5.0 * before) / (after - before);
    const double position = middle + 2.5 - share;
    if (std::abs(position - middle) > 2.5) continue;
    points.push_back({static_cast<double>(along), position});
  }
  return fit_line(points, static_cast<std::size_t>(std::max(count, 6)), 0.15, parameters, side) &&
         side.rms <= parameters.max_rms_px;
}

std::array<Line, 4> lines_of(const std::array<Side, 4>& sides) {
  std::array<Line, 4> lines;
  for (std::size_t k = 0; k < 4; ++k) lines[k] = line_of(sides[k], sides[k].p, sides[k].q);
  return lines;
}

}  // namespace

std::optional<SquareOutline> fit_square(const PlaneImage& contrast, const Mask& mask, const PatchFrame& frame,
                                        const OutlineParameters& parameters) {
  const auto start = lines_from_moments(mask, parameters.min_squareness);
  if (!start) return std::nullopt;
  const auto rough = corners_of(*start);
  if (!rough) return std::nullopt;
  std::array<Side, 4> sides;
  for (std::size_t k = 0; k < 4; ++k) {
    // Corner k lies between sides k and k + 1.
    sides[k] = side_of((*start)[k], (*rough)[(k + 3) % 4], (*rough)[k], parameters.corner_share);
    if (sides[k].to - sides[k].from < 5.0) return std::nullopt;
    if (!fit_to_mask(mask, parameters, sides[k])) return std::nullopt;
    if (!fit_to_contrast(contrast, parameters, sides[k])) return std::nullopt;
  }
  const auto corners = corners_of(lines_of(sides));
  if (!corners) return std::nullopt;
  const auto centre = diagonals_meet(*corners);
  if (!centre || !centre->allFinite()) return std::nullopt;

  Eigen::Matrix2d covariance = Eigen::Matrix2d::Identity() * parameters.centre_floor_px * parameters.centre_floor_px;
  SquareOutline outline;
  for (std::size_t k = 0; k < 4; ++k) {
    constexpr double kStep = 1e-3;
    Eigen::Matrix2d jacobian;
    for (int parameter = 0; parameter < 2; ++parameter) {
      const double step = parameter == 0 ? kStep : kStep / std::max(1.0, sides[k].to - sides[k].from);
      auto lines = lines_of(sides);
      lines[k] =
          line_of(sides[k], sides[k].p + (parameter == 0 ? step : 0.0), sides[k].q + (parameter == 1 ? step : 0.0));
      const auto moved_corners = corners_of(lines);
      const auto moved = moved_corners ? diagonals_meet(*moved_corners) : std::nullopt;
      if (!moved) return std::nullopt;
      jacobian.col(parameter) = (*moved - *centre) / step;
    }
    covariance += jacobian * sides[k].covariance * jacobian.transpose();
    outline.worst_rms_px = std::max(outline.worst_rms_px, sides[k].rms);
  }
  const auto to_image = [&frame](const Eigen::Vector2d& p) {
    return Eigen::Vector2d(frame.u_of(p.x()), frame.v_of(p.y()));
  };
  outline.centre = to_image(*centre);
  outline.covariance = covariance * frame.scale * frame.scale;
  for (std::size_t k = 0; k < 4; ++k) outline.corners[k] = to_image((*corners)[k]);
  return outline;
}

}  // namespace markservo::target_locator
