#include "services/rfid-localizer/round_match.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace markservo::rfid_localizer {
namespace {

// The prior's ellipse: p = mean + axes * u, u in standard deviations.
struct Ellipse {
  Eigen::Vector2d mean;
  Eigen::Matrix2d axes;
};

// Points evenly spaced in u around `centre`.
struct Grid {
  Eigen::Vector2d centre;  // of u
  Eigen::Vector2d half;    // half extent of u
  int points = 0;          // each way

  Eigen::Vector2d step() const { return 2.0 * half / (points - 1); }
};

struct Sums {
  double weight = 0.0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();  // of u
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();

  void add(const Eigen::Vector2d& u, double weight_here) {
    weight += weight_here;
    first += weight_here * u;
    second += weight_here * u * u.transpose();
  }
  Eigen::Vector2d mean() const { return first / weight; }
  Eigen::Matrix2d spread() const { return second / weight - mean() * mean().transpose(); }
};

struct Product {
  double prior = 0.0;
  Sums all;
  std::vector<Eigen::Vector2d> points;  // u of the grid
  std::vector<double> weights;          // prior times likelihood there
  std::vector<double> inside;           // sums weighted by those, per outcome
  std::vector<double> reading;          // sums of the read probability weighted by the prior, per outcome
};

double footprint(const Eigen::Vector2d& p, const TagOutcome& tag, const std::vector<WindowPoint>& window,
                 const ReadModel& model) {
  if (tag.read && tag.moment_known) return model.inside((p + tag.offset - tag.p_W).squaredNorm());
  double sum = 0.0;
  for (const WindowPoint& point : window) {
    sum += point.weight * model.inside((p + point.offset - tag.p_W).squaredNorm());
  }
  return sum;
}

// Rows and columns of the grid from which the antenna may reach a tag: no others need be tried.
struct Block {
  int first_row, last_row;  // the last ones included
  int first_column, last_column;

  bool has(int row, int column) const {
    return row >= first_row && row <= last_row && column >= first_column && column <= last_column;
  }
};

Block block_of(const TagOutcome& tag, const Ellipse& ellipse, const Grid& grid, double reach) {
  const Eigen::Vector2d step = grid.step();
  // The axes are orthogonal: their inverse is their transpose, scaled.
  const Eigen::Vector2d squares = ellipse.axes.colwise().squaredNorm();
  const Eigen::Vector2d u = (ellipse.axes.transpose() * (tag.p_W - ellipse.mean)).cwiseQuotient(squares);
  const Eigen::Vector2d half = reach * squares.cwiseSqrt().cwiseInverse();
  const double most = grid.points;
  const auto index = [&](int axis, double place) {
    return std::clamp((place - grid.centre[axis] + grid.half[axis]) / step[axis], -1.0, most);
  };
  return {static_cast<int>(std::ceil(std::max(index(0, u[0] - half[0]), 0.0))),
          static_cast<int>(std::floor(std::min(index(0, u[0] + half[0]), most - 1.0))),
          static_cast<int>(std::ceil(std::max(index(1, u[1] - half[1]), 0.0))),
          static_cast<int>(std::floor(std::min(index(1, u[1] + half[1]), most - 1.0)))};
}

Product multiply(const Ellipse& ellipse, const Grid& grid, const std::vector<TagOutcome>& outcomes,
                 const std::vector<WindowPoint>& window, const ReadModel& model, double false_read) {
  Product product;
  std::vector<double> priors;
  for (int i = 0; i < grid.points; ++i) {
    for (int j = 0; j < grid.points; ++j) {
      const Eigen::Vector2d u = grid.centre - grid.half + grid.step().cwiseProduct(Eigen::Vector2d(i, j));
      product.points.push_back(u);
      priors.push_back(std::exp(-0.5 * u.squaredNorm()));
      product.prior += priors.back();
    }
  }
  product.weights = priors;
  const auto number = [&grid](int row, int column) { return static_cast<std::size_t>(row * grid.points + column); };

  double farthest = 0.0;  // of the antenna from its place in the round's middle
  for (const WindowPoint& point : window) farthest = std::max(farthest, point.offset.norm());
  std::vector<Block> blocks;
  std::vector<double> footprints;  // of all blocks, one after the other
  for (const TagOutcome& tag : outcomes) {
    const double offset = tag.read && tag.moment_known ? tag.offset.norm() : farthest;
    const Block block = block_of(tag, ellipse, grid, model.reach() + offset);
    blocks.push_back(block);
    if (tag.read) {
      for (int i = 0; i < grid.points; ++i) {
        for (int j = 0; j < grid.points; ++j) {
          if (!block.has(i, j)) product.weights[number(i, j)] *= false_read;
        }
      }
    }
    double reading_sum = 0.0;
    for (int i = block.first_row; i <= block.last_row; ++i) {
      for (int j = block.first_column; j <= block.last_column; ++j) {
        const std::size_t k = number(i, j);
        footprints.push_back(footprint(ellipse.mean + ellipse.axes * product.points[k], tag, window, model));
        const double reading = tag.reliability * footprints.back();
        reading_sum += priors[k] * reading;
        product.weights[k] *= tag.read ? reading + false_read : 1.0 - reading;
      }
    }
    product.reading.push_back(reading_sum);
  }
  for (std::size_t k = 0; k < product.points.size(); ++k) product.all.add(product.points[k], product.weights[k]);

  std::size_t next = 0;
  for (const Block& block : blocks) {
    double sum = 0.0;
    for (int i = block.first_row; i <= block.last_row; ++i) {
      for (int j = block.first_column; j <= block.last_column; ++j) {
        sum += product.weights[number(i, j)] * footprints[next++];
      }
    }
    product.inside.push_back(sum);
  }
  return product;
}

PlacePart part(const Sums& sums, double total, const Ellipse& ellipse) {
  return {sums.weight / total, ellipse.mean + ellipse.axes * sums.mean(),
          ellipse.axes * sums.spread() * ellipse.axes.transpose()};
}

// One Gaussian, or two or three that share the grid's points along the longer axis.
std::vector<PlacePart> parts_of(const Product& product, const Ellipse& ellipse, double widest) {
  const PlacePart whole = part(product.all, product.all.weight, ellipse);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(whole.covariance);
  const double sigma = std::sqrt(std::max(solver.eigenvalues()[1], 0.0));
  if (sigma <= widest) return {whole};
  const int count = sigma <= 2.0 * widest ? 2 : 3;
  constexpr double kThird = 0.6;  // standard deviations from the mean: cuts about a quarter off at each side
  const Eigen::Vector2d axis = solver.eigenvectors().col(1);
  std::vector<Sums> sums(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < product.points.size(); ++i) {
    const double along = axis.dot(ellipse.mean + ellipse.axes * product.points[i] - whole.mean) / sigma;
    std::size_t place = along < 0.0 ? 0 : 1;
    if (count == 3) place = along < -kThird ? 0 : (along > kThird ? 2 : 1);
    sums[place].add(product.points[i], product.weights[i]);
  }
  std::vector<PlacePart> parts;
  for (const Sums& one : sums) {
    if (one.weight > 0.0) parts.push_back(part(one, product.all.weight, ellipse));
  }
  // A grid's few points can lie on one line.
  constexpr double kThinnest = 1e-7;  // m^2
  for (PlacePart& one : parts) one.covariance += kThinnest * Eigen::Matrix2d::Identity();
  return parts;
}

}  // namespace

std::vector<WindowPoint> window_points(const Eigen::Vector2d& way) {
  constexpr double kStanding = 0.002;  // m
  if (way.norm() < kStanding) return {{Eigen::Vector2d::Zero(), 1.0}};
  // Gauss-Legendre of three points, over half the way to either side.
  const Eigen::Vector2d node = std::sqrt(0.6) * 0.5 * way;
  return {{-node, 5.0 / 18.0}, {Eigen::Vector2d::Zero(), 8.0 / 18.0}, {node, 5.0 / 18.0}};
}

RoundMatch match_round(const Eigen::Vector2d& prior_mean, const Eigen::Matrix2d& prior_covariance,
                       const std::vector<TagOutcome>& outcomes, const std::vector<WindowPoint>& window,
                       const ReadModel& model, const RoundMatchParameters& parameters) {
  if (outcomes.empty()) return {{{1.0, prior_mean, prior_covariance}}, 1.0, {}, {}};
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver(prior_covariance);
  const Eigen::Vector2d sigmas = solver.eigenvalues().cwiseMax(1e-12).cwiseSqrt();
  const Ellipse ellipse{prior_mean, solver.eigenvectors() * sigmas.asDiagonal()};

  // No wider than the edge is soft, or the grid would step over what the tags say.
  const double extent = 2.0 * parameters.span * sigmas.maxCoeff();
  const int wanted = static_cast<int>(std::ceil(std::min(extent / model.softness(), 1e3))) + 1;
  Grid grid{Eigen::Vector2d::Zero(), Eigen::Vector2d::Constant(parameters.span),
            std::clamp(wanted, parameters.least_points, parameters.most_points)};
  Product product = multiply(ellipse, grid, outcomes, window, model, parameters.false_read);
  RoundMatch match;
  match.chance = product.reading;
  for (double& chance : match.chance) chance /= product.prior;
  if (!(product.all.weight > 0.0)) {  // everything contradicts everything
    match.parts = {{1.0, prior_mean, prior_covariance}};
    match.inside.assign(outcomes.size(), 0.0);
    return match;
  }
  match.evidence = product.all.weight / product.prior;

  // Far narrower than the grid: once more, where it lies.
  const Eigen::Vector2d narrow = product.all.spread().diagonal().cwiseMax(0.0).cwiseSqrt();
  constexpr double kNarrow = 0.4;  // standard deviations of the prior
  constexpr double kMargin = 4.0;  // standard deviations of what was found
  if (narrow.minCoeff() < kNarrow || grid.points == parameters.most_points) {
    const double spacing = 2.0 * grid.half.x() / (grid.points - 1);
    grid.centre += product.all.mean();
    grid.half = (kMargin * narrow).array() + spacing;
    Product finer = multiply(ellipse, grid, outcomes, window, model, parameters.false_read);
    if (finer.all.weight > 0.0) product = std::move(finer);
  }
  match.parts = parts_of(product, ellipse, parameters.widest * model.softness());
  match.inside = std::move(product.inside);
  for (double& inside : match.inside) inside /= product.all.weight;
  return match;
}

}  // namespace markservo::rfid_localizer
