#include "services/target-locator/hidden/hidden_sides.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace markservo::target_locator {
namespace {

constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;
constexpr std::size_t kLeastPoints = 60;
constexpr std::size_t kStrays = 2;  // outermost points that may be noise

using Points = std::vector<Eigen::Vector2d>;

// Metric coordinates on the mark's plane in space: first axis as far along the images' rows as it can be.
class PlaneAxes {
 public:
  PlaneAxes(const DisparityPlane& plane, const geometry::StereoCamera& camera) : plane_(plane), camera_(camera) {
    const Eigen::Vector3d normal = plane_normal(plane, camera);
    first_ = (Eigen::Vector3d::UnitX() - normal * normal.x()).normalized();
    second_ = first_.cross(normal);
    origin_ = point(plane.u0, plane.v0).value_or(Eigen::Vector3d::Zero());
  }
  // m in C; nothing where the plane is not in front of the cameras.
  std::optional<Eigen::Vector3d> point(double u_left, double v) const {
    return geometry::triangulate(camera_, {u_left, v, u_left - plane_.at(u_left, v)});
  }
  std::optional<Eigen::Vector2d> place(double u_left, double v) const {
    const auto p_C = point(u_left, v);
    if (!p_C) return std::nullopt;
    return Eigen::Vector2d(first_.dot(*p_C - origin_), second_.dot(*p_C - origin_));
  }
  std::optional<Eigen::Vector2d> image(const Eigen::Vector2d& place) const {
    const auto seen = geometry::project(camera_, origin_ + place.x() * first_ + place.y() * second_);
    if (!seen) return std::nullopt;
    return Eigen::Vector2d(seen->u_left, seen->v);
  }
  double depth() const { return origin_.y(); }

 private:
  const DisparityPlane& plane_;
  const geometry::StereoCamera& camera_;
  Eigen::Vector3d first_;
  Eigen::Vector3d second_;
  Eigen::Vector3d origin_;
};

// Calls `use(column, row)` for every place between a pixel of the mask and one that is not.
template <typename Use>
void for_each_edge(const Mask& mask, const Use& use) {
  const auto at = [&mask](int x, int y) {
    return x >= 0 && y >= 0 && x < mask.width() && y < mask.height() && mask.test(x, y);
  };
  for (int y = 0; y < mask.height(); ++y) {
    for (int x = -1; x < mask.width(); ++x) {
      if (at(x, y) != at(x + 1, y)) use(x + 0.5, static_cast<double>(y));
    }
  }
  for (int y = -1; y < mask.height(); ++y) {
    for (int x = 0; x < mask.width(); ++x) {
      if (at(x, y) != at(x, y + 1)) use(static_cast<double>(x), y + 0.5);
    }
  }
}

// The outline of what the two views show, on the plane.
struct Outlines {
  std::array<Points, 2> views;  // left, right
  double pixel = 0.0;           // m, a patch pixel on the plane
};

std::optional<Outlines> outlines_on_plane(const MaskedView& left, const MaskedView& right, const PlaneAxes& axes,
                                          const DisparityPlane& plane, double row_offset,
                                          const geometry::StereoCamera& camera) {
  Outlines outlines;
  bool in_front = true;
  const auto add = [&](std::size_t view, double u_left, double v) {
    const auto place = axes.place(u_left, v);
    if (place) {
      outlines.views[view].push_back(*place);
    } else {
      in_front = false;
    }
  };
  for_each_edge(left.mask, [&](double column, double row) { add(0, left.frame.u_of(column), left.frame.v_of(row)); });
  for_each_edge(right.mask, [&](double column, double row) {
    const double u = right.frame.u_of(column);
    const double v = right.frame.v_of(row) - row_offset;
    // The plane's disparity is linear in u_left = u + disparity.
    add(1, u + plane.at(u, v) / (1.0 - plane.along_u), v);
  });
  if (!in_front || outlines.views[0].size() < kLeastPoints || outlines.views[1].size() < kLeastPoints) {
    return std::nullopt;
  }
  outlines.pixel = axes.depth() / camera.fx * std::max(left.frame.scale, right.frame.scale);
  return outlines;
}

double nth_value(std::vector<double> values, std::size_t n) {
  std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(n), values.end());
  return values[n];
}

// The outlines' outermost edge in one direction: `out` is how far out, `along` where along the edge.
struct Outermost {
  double out = 0.0;     // m, of the edge
  double length = 0.0;  // m, of its straight part
  double slope = 0.0;   // of the edge against the square's side
  double slope_sigma = 1.0;
  double rms = 0.0;  // m, about its line
};

Outermost outermost_edge(const Points& points, const Eigen::Vector2d& outwards, double pixel) {
  const Eigen::Vector2d sideways(-outwards.y(), outwards.x());
  std::vector<double> inwards;
  double first = 1e9;
  double last = -1e9;
  for (const auto& point : points) {
    inwards.push_back(-outwards.dot(point));
    first = std::min(first, sideways.dot(point));
    last = std::max(last, sideways.dot(point));
  }
  const double limit = nth_value(inwards, kStrays);
  // How far out the outline reaches, pixel by pixel along the edge.
  constexpr double kLongest = 4096.0;  // pixels; no patch is as long
  if (!((last - first) / pixel <= kLongest)) return {};
  const auto count = static_cast<std::size_t>((last - first) / pixel) + 1;
  std::vector<double> reach(count, -1e9);
  for (const auto& point : points) {
    double& here = reach[static_cast<std::size_t>((sideways.dot(point) - first) / pixel)];
    here = std::max(here, outwards.dot(point));
  }
  // The longest stretch near the outermost point.
  const double band = 2.5 * pixel;
  std::size_t best_begin = 0;
  std::size_t best_end = 0;
  for (std::size_t begin = 0; begin < count;) {
    std::size_t end = begin;
    while (end < count && reach[end] >= -limit - band) ++end;
    if (end - begin > best_end - best_begin) {
      best_begin = begin;
      best_end = end;
    }
    begin = end + 1;
  }
  Outermost edge;
  edge.out = -limit;
  const double n = static_cast<double>(best_end - best_begin);
  edge.length = n * pixel;
  if (n < 3.0) return edge;
  double mean = 0.0;
  for (std::size_t i = best_begin; i < best_end; ++i) mean += reach[i] / n;
  const double middle = 0.5 * static_cast<double>(best_begin + best_end - 1);
  double cross = 0.0;
  double squares = 0.0;
  for (std::size_t i = best_begin; i < best_end; ++i) {
    const double t = (static_cast<double>(i) - middle) * pixel;
    cross += t * (reach[i] - mean);
    squares += t * t;
  }
  edge.slope = cross / squares;
  for (std::size_t i = best_begin; i < best_end; ++i) {
    const double off = reach[i] - mean - edge.slope * (static_cast<double>(i) - middle) * pixel;
    edge.rms += off * off / n;
  }
  edge.rms = std::sqrt(edge.rms);
  edge.slope_sigma = std::max(edge.rms, 0.3 * pixel) / std::sqrt(squares);
  edge.out = mean;
  return edge;
}

// How many points lie on the outermost lines of that direction and its opposite, or nothing if these are farther apart
// than `most`.
std::optional<int> support(const std::vector<double>& values, double tolerance, double most) {
  const double low = nth_value(values, kStrays);
  const double high = nth_value(values, values.size() - 1 - kStrays);
  if (high - low > most) return std::nullopt;
  return static_cast<int>(std::count_if(
      values.begin(), values.end(), [&](double value) { return value < low + tolerance || value > high - tolerance; }));
}

// The turn of the square (rad, within 45 degrees) whose sides most of the outlines lie on.
std::optional<double> best_turn(const Outlines& outlines, double most_extent) {
  Points all = outlines.views[0];
  all.insert(all.end(), outlines.views[1].begin(), outlines.views[1].end());
  const double tolerance = 0.9 * outlines.pixel;
  std::vector<double> values(all.size());
  double best = 0.0;
  int most = 0;
  const auto try_turn = [&](double turn) {
    int sum = 0;
    for (const Eigen::Vector2d& axis :
         {Eigen::Vector2d(std::cos(turn), std::sin(turn)), Eigen::Vector2d(-std::sin(turn), std::cos(turn))}) {
      std::transform(all.begin(), all.end(), values.begin(), [&axis](const auto& point) { return axis.dot(point); });
      const auto count = support(values, tolerance, most_extent);
      if (!count) return;
      sum += *count;
    }
    if (sum > most) {
      most = sum;
      best = turn;
    }
  };
  constexpr int kCoarse_deg = 1;
  for (int degrees = -45; degrees < 45; degrees += kCoarse_deg) try_turn(degrees * kRadPerDeg);
  if (most == 0) return std::nullopt;
  const double coarse = best;
  constexpr int kFineSteps = 5;
  for (int k = -kFineSteps; k <= kFineSteps; ++k) try_turn(coarse + k * 0.2 * kCoarse_deg * kRadPerDeg);
  return best;
}

// The turn that most of the outermost edges by length are parallel to, from one near it. What hides has edges of its
// own, but hardly as many that are parallel or square to each other.
double aligned_turn(const Outlines& outlines, double turn) {
  constexpr double kParallel = 0.006;  // rad
  std::vector<Outermost> edges;
  for (int k = 0; k < 4; ++k) {
    const double angle = turn + 90.0 * kRadPerDeg * k;
    for (const Points& points : outlines.views) {
      edges.push_back(outermost_edge(points, {std::cos(angle), std::sin(angle)}, outlines.pixel));
    }
  }
  double most = 0.0;
  double best = 0.0;
  for (const Outermost& candidate : edges) {
    double length = 0.0;
    double weights = 0.0;
    double sum = 0.0;
    for (const Outermost& edge : edges) {
      if (std::abs(edge.slope - candidate.slope) > std::max(kParallel, 2.5 * edge.slope_sigma)) continue;
      const double weight = 1.0 / (edge.slope_sigma * edge.slope_sigma);
      length += edge.length;
      weights += weight;
      sum += weight * edge.slope;
    }
    if (length > most) {
      most = length;
      best = sum / weights;
    }
  }
  // A side's reach grows along it as the square turns the other way.
  return turn - best;
}

// The centre's coordinate along one axis of the square.
struct Coordinate {
  double mean = 0.0;      // m
  double variance = 0.0;  // m^2
};

class AxisEvidence {
 public:
  // `crossings`: of pixels by a whole side across the axis.
  AxisEvidence(const Outlines& outlines, const Eigen::Vector2d& axis, double separation, double crossings, double size,
               const HiddenSidesParameters& parameters)
      : size_(size), pixel_(outlines.pixel), parameters_(parameters) {
    // A side along the pixels is known to the pixel it lies in; one across them averages that.
    const double rounding = 1.0 / (12.0 * std::pow(1.0 + crossings, 2));
    edge_variance_ = (std::pow(parameters.edge_floor_px, 2) + rounding) * pixel_ * pixel_;
    // How far apart on the plane the cameras see the edge of something nearer, across such an edge.
    apart_ = separation * std::abs(axis.x());
    low_ = side(outlines, -axis);
    high_ = side(outlines, axis);
    low_.out = -low_.out;
  }

  std::optional<Coordinate> centre() const {
    const double extent = high_.out - low_.out;
    const double middle = 0.5 * (low_.out + high_.out);
    const double edge = edge_variance_;
    const double missing = size_ - extent;
    if (missing < -parameters_.most_too_large * size_ - pixel_) return std::nullopt;
    if (missing <= parameters_.size_tolerance * size_ + 0.5 * pixel_) {
      return Coordinate{middle, 0.5 * edge + missing * missing / 12.0};
    }
    // At least one of the two is hidden.
    const std::array<double, 3> weight = {low_.likely * (1.0 - high_.likely), high_.likely * (1.0 - low_.likely),
                                          parameters_.two_things * (1.0 - low_.likely) * (1.0 - high_.likely)};
    const double size_variance = std::pow(0.5 * parameters_.size_sigma * size_, 2);
    const std::array<Coordinate, 3> centres = {
        Coordinate{low_.out + 0.5 * size_, edge + size_variance},
        Coordinate{high_.out - 0.5 * size_, edge + size_variance},
        Coordinate{middle, missing * missing / 12.0 + edge},
    };
    double all = 0.0;
    for (const double w : weight) all += w;
    double sum = 0.0;
    Coordinate mixed;
    for (std::size_t k = 0; k < 3; ++k) {
      if (weight[k] < parameters_.unlikely * all) continue;
      sum += weight[k];
      mixed.mean += weight[k] * centres[k].mean;
    }
    mixed.mean /= sum;
    for (std::size_t k = 0; k < 3; ++k) {
      if (weight[k] < parameters_.unlikely * all) continue;
      const double off = centres[k].mean - mixed.mean;
      mixed.variance += weight[k] / sum * (centres[k].variance + off * off);
    }
    return mixed;
  }

 private:
  struct Side {
    double out = 0.0;     // m along the axis
    double likely = 0.0;  // that it is a side of the square
  };

  // The outermost edge of either view.
  Side side(const Outlines& outlines, const Eigen::Vector2d& outwards) const {
    std::array<Outermost, 2> edges;
    for (std::size_t view = 0; view < 2; ++view) {
      edges[view] = outermost_edge(outlines.views[view], outwards, pixel_);
    }
    const bool left_is_outer = edges[0].out >= edges[1].out;
    const Outermost& outer = left_is_outer ? edges[0] : edges[1];
    const Outermost& inner = left_is_outer ? edges[1] : edges[0];
    const double tolerance = 1.0 * pixel_;
    if (!straight(outer)) {
      constexpr double kTip = 0.02;
      return {outer.out, kTip};
    }
    const bool both = straight(inner) && outer.out - inner.out <= tolerance;
    if (!both) return {outer.out, 0.5};
    constexpr double kSeenByBoth = 0.99;
    return {0.5 * (outer.out + inner.out), apart_ > 2.0 * tolerance ? kSeenByBoth : 0.5};
  }

  bool straight(const Outermost& edge) const {
    const double crooked = std::max(parameters_.crooked_rad, 3.0 * edge.slope_sigma);
    return edge.length >= parameters_.least_length * size_ && std::abs(edge.slope) <= crooked && edge.rms <= pixel_;
  }

  double size_;
  double pixel_;
  double apart_ = 0.0;
  double edge_variance_ = 0.0;  // m^2
  const HiddenSidesParameters& parameters_;
  Side low_;
  Side high_;
};

// Rows or columns of patch pixels, the fewer, that a line of `extent` (m, on the plane) crosses.
double pixel_crossings(const PlaneAxes& axes, const Eigen::Vector2d& extent, double scale) {
  const auto from = axes.image(Eigen::Vector2d::Zero());
  const auto to = axes.image(extent);
  return from && to ? (*to - *from).cwiseAbs().minCoeff() / scale : 0.0;
}

}  // namespace

std::optional<ImageCentre> centre_of_hidden_square(const MaskedView& left, const MaskedView& right,
                                                   const DisparityPlane& plane, double row_offset,
                                                   const geometry::StereoCamera& camera, double size,
                                                   const HiddenSidesParameters& parameters) {
  const PlaneAxes axes(plane, camera);
  if (!(axes.depth() > parameters.least_gap)) return std::nullopt;
  const auto outlines = outlines_on_plane(left, right, axes, plane, row_offset, camera);
  if (!outlines) return std::nullopt;
  const auto rough_turn = best_turn(*outlines, (1.0 + parameters.most_too_large) * size + outlines->pixel);
  if (!rough_turn) return std::nullopt;
  const double turn = aligned_turn(*outlines, aligned_turn(*outlines, *rough_turn));
  const double separation = camera.baseline * parameters.least_gap / (axes.depth() - parameters.least_gap);
  const Eigen::Vector2d first(std::cos(turn), std::sin(turn));
  const Eigen::Vector2d second(-first.y(), first.x());
  const auto along_axis = [&](const Eigen::Vector2d& axis) {
    const double crossings = pixel_crossings(axes, Eigen::Vector2d(-axis.y(), axis.x()) * size, left.frame.scale);
    return AxisEvidence(*outlines, axis, separation, crossings, size, parameters).centre();
  };
  const auto along_first = along_axis(first);
  const auto along_second = along_axis(second);
  if (!along_first || !along_second) return std::nullopt;

  const Eigen::Vector2d place = along_first->mean * first + along_second->mean * second;
  const Eigen::Matrix2d on_plane =
      along_first->variance * first * first.transpose() + along_second->variance * second * second.transpose();
  const auto position = axes.image(place);
  if (!position) return std::nullopt;
  Eigen::Matrix2d jacobian;
  for (int k = 0; k < 2; ++k) {
    const auto moved = axes.image(place + outlines->pixel * Eigen::Vector2d::Unit(k));
    if (!moved) return std::nullopt;
    jacobian.col(k) = (*moved - *position) / outlines->pixel;
  }
  return ImageCentre{*position, jacobian * on_plane * jacobian.transpose()};
}

}  // namespace markservo::target_locator
