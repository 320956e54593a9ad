#include "services/target-locator/contour/contour_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "services/target-locator/contour/chance.hpp"
#include "services/target-locator/contour/contour_pixels.hpp"
#include "services/target-locator/contour/ellipse_contour.hpp"
#include "services/target-locator/contour/quad_contour.hpp"

namespace markservo::target_locator {
namespace {

// How the levels on either side of the outline may change.
enum class Levels {
  kEven,    // not at all
  kVaried,  // around, as light, shadows and what lies behind make them
};

// What a block says when it is held against the fit.
struct BlockSums {
  double count = 0.0;
  double squares = 0.0;                  // of residuals
  double score = 0.0;                    // of residuals times what they change by when the outline moves outwards
  double information = 0.0;              // of the squares of that
  double contrast = 0.0;                 // summed over `count`
  std::array<double, 2> beyond{};        // of residuals outside and inside the blur's reach
  std::array<double, 2> beyond_count{};  // of pixels there
};

// Derivatives by the few unknowns that a pixel depends on.
struct SparseRow {
  static constexpr std::size_t kMost = kMostShapeParameters + 1 + 4;  // shape, blur, two levels on either side

  std::array<int, kMost> index{};
  std::array<double, kMost> derivative{};
  std::size_t size = 0;

  void put(int i, double d) {
    if (d == 0.0) return;
    index[size] = i;
    derivative[size++] = d;
  }
};

// Over the pixels that are used.
struct Totals {
  double squares = 0.0;  // of residuals
  double count = 0.0;
};

// The whole least-squares problem. Unknowns: the shape's, the blur, the level inside and the one outside, or
// parameters.levels_around of each where they vary.
template <class Shape>
class ContourProblem {
 public:
  ContourProblem(const PlaneImage& image, const Shape& start, const ContourFitParameters& parameters)
      : parameters_(parameters),
        shape_(start),
        about_(pixels_about(image, start, parameters.reach_in, parameters.reach_out,
                            static_cast<std::size_t>(std::max(8.0, start.perimeter() / parameters.block_px)))) {
    begin(start, Levels::kEven);
  }

  void begin(const Shape& start, Levels allowed) {
    allowed_ = allowed;
    shape_ = start;
    blur_ = parameters_.start_blur;
    inside_ = Eigen::VectorXd::Ones(parameters_.levels_around);
    outside_ = Eigen::VectorXd::Zero(parameters_.levels_around);
  }

  // Beyond the blur's reach the residuals of the blocks are more than noise.
  bool levels_vary() const {
    const double variance = robust_variance();
    double chi_square = 0.0;
    double n = 0.0;
    for (const BlockSums& block : blocks_) {
      for (std::size_t side = 0; side < 2; ++side) {
        if (!(block.beyond_count[side] > 0.0)) continue;
        chi_square += block.beyond[side] * block.beyond[side] / (block.beyond_count[side] * variance);
        n += 1.0;
      }
    }
    return !(chi_square <= n + parameters_.varied_sigmas * std::sqrt(2.0 * n));
  }

  // False when it does not settle near the start.
  bool iterate() {
    double moved = 0.0;
    for (int k = 0; k < parameters_.max_iterations; ++k) {
      const auto step = linearise();
      if (!step) return false;
      typename Shape::Vector change = step->template head<Shape::kSize>();
      shape_.change(change);
      if (!shape_.is_sane()) return false;
      const double blur_step = (*step)[Shape::kSize];
      constexpr double kMostBlurStep = 0.3;  // px, beyond which the outline's model is no longer linear
      blur_ = std::clamp(blur_ + std::clamp(blur_step, -kMostBlurStep, kMostBlurStep), parameters_.min_blur,
                         parameters_.max_blur);
      change_levels(step->tail(step->size() - Shape::kSize - 1));
      const double size = move_of(change);
      moved += size;
      if (!(moved < parameters_.max_move)) return false;
      if (size < parameters_.settled_px && std::abs(blur_step) < 0.05) break;
    }
    return linearise().has_value();
  }

  // Leaves out the blocks that the fit does not explain; how many.
  int drop_outliers() {
    const double variance = robust_variance();
    int dropped = 0;
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const BlockSums& block = blocks_[b];
      if (!about_.used[b] || !(block.count > 0.0)) continue;
      const double limit = parameters_.outlier_sigmas;
      const double scatter = 1.0 + limit * std::sqrt(2.0 / block.count);
      const bool off = std::abs(block.score) > std::max(limit * std::sqrt(variance * block.information),
                                                        parameters_.outlier_px * block.information);
      const double noise_2 = std::max(scatter * variance, std::pow(parameters_.outlier_noise, 2));
      const bool rough = block.squares > noise_2 * block.count;
      const bool pale = block.contrast < parameters_.min_contrast * block.count;
      if (!off && !rough && !pale) continue;
      about_.used[b] = false;
      ++dropped;
    }
    return dropped;
  }

  bool enough_is_left() const {
    const std::size_t n = about_.used.size();
    std::array<double, 4> kept{};
    std::array<double, 4> all{};
    for (std::size_t b = 0; b < n; ++b) {
      const std::size_t quarter = 4 * b / n;
      all[quarter] += 1.0;
      // The patch may end at a part of the outline.
      if (about_.used[b] && blocks_[b].count > 0.0) kept[quarter] += 1.0;
    }
    double total = 0.0;
    for (std::size_t q = 0; q < 4; ++q) {
      if (kept[q] < parameters_.min_kept_quarter * all[q]) return false;
      total += kept[q];
    }
    return total >= parameters_.min_kept * static_cast<double>(n);
  }

  // After iterate().
  std::optional<FittedContour<Shape>> result() const {
    FittedContour<Shape> fitted{shape_, {}, blur_, 1.0};
    const double unknowns = static_cast<double>(information_.rows());
    if (!(totals_.count > 2.0 * unknowns)) return std::nullopt;
    const double variance = std::max(totals_.squares / (totals_.count - unknowns), std::pow(parameters_.min_noise, 2));
    fitted.roughness = roughness(variance);
    const Eigen::MatrixXd inverse = solver_.solve(Eigen::MatrixXd::Identity(information_.rows(), information_.rows()));
    fitted.covariance = fitted.roughness * variance * inverse.template topLeftCorner<Shape::kSize, Shape::kSize>();
    if (!fitted.covariance.allFinite()) return std::nullopt;
    return fitted;
  }

 private:
  // Weights of the two levels next to a place around the outline.
  struct LevelWeights {
    int first;
    int second;
    double of_second;

    double of(const Eigen::VectorXd& levels) const {
      return (1.0 - of_second) * levels[first] + of_second * levels[second];
    }
  };
  LevelWeights levels_at(double around) const {
    const int n = parameters_.levels_around;
    const double place = around * n;
    const int whole = std::min(static_cast<int>(place), n - 1);
    return {whole, (whole + 1) % n, place - whole};
  }

  int level_unknowns() const { return allowed_ == Levels::kEven ? 2 : 2 * parameters_.levels_around; }

  void change_levels(const Eigen::VectorXd& by) {
    if (allowed_ == Levels::kVaried) {
      inside_ += by.head(inside_.size());
      outside_ += by.tail(outside_.size());
    } else {
      inside_.array() += by[0];
      outside_.array() += by[1];
    }
  }

  // px that the outline moves by, about.
  double move_of(const typename Shape::Vector& change) const {
    double most = 0.0;
    for (const auto& outwards : outwards_) most = std::max(most, std::abs(outwards.dot(change)));
    return most;
  }

  // The normal equations about the present values; their solution.
  std::optional<Eigen::VectorXd> linearise() {
    const int unknowns = Shape::kSize + 1 + level_unknowns();
    information_ = Eigen::MatrixXd::Zero(unknowns, unknowns);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(unknowns);
    blocks_.assign(about_.used.size(), BlockSums());
    gradients_.setZero(unknowns, static_cast<Eigen::Index>(blocks_.size()));
    outwards_.clear();
    totals_ = {};
    for (const ContourPixel& pixel : about_.pixels) add(pixel, right);
    // Levels of which the patch shows nothing stay as they are.
    constexpr double kHardlyAny = 1e-3;  // pixels
    for (int k = Shape::kSize + 1; k < unknowns; ++k) information_(k, k) += kHardlyAny;
    solver_.compute(information_.selfadjointView<Eigen::Lower>());
    if (solver_.info() != Eigen::Success) return std::nullopt;
    Eigen::VectorXd step = solver_.solve(right);
    return step.allFinite() ? std::make_optional(step) : std::nullopt;
  }

  void add(const ContourPixel& pixel, Eigen::VectorXd& right) {
    const Coverage coverage = shape_.at(pixel.x, pixel.y, blur_);
    constexpr double kOnOutline_px = 0.5;
    if (std::abs(coverage.distance) <= kOnOutline_px) {
      outwards_.push_back(Eigen::Map<const typename Shape::Vector>(coverage.by_shape.data()) / coverage.by_distance);
    }
    const LevelWeights w = levels_at(coverage.around);
    const double outside = w.of(outside_);
    const double contrast = w.of(inside_) - outside;
    const double residual = pixel.value - outside - contrast * coverage.share;
    add_to_block(coverage, contrast, residual, blocks_[pixel.block]);
    if (!about_.used[pixel.block]) return;
    totals_.squares += residual * residual;
    totals_.count += 1.0;
    const SparseRow row = row_of(coverage, w, contrast);
    const double by_move = contrast * coverage.by_distance;
    for (std::size_t i = 0; i < row.size; ++i) {
      gradients_(row.index[i], static_cast<Eigen::Index>(pixel.block)) += row.derivative[i] * by_move;
      right[row.index[i]] += row.derivative[i] * residual;
      for (std::size_t k = 0; k < row.size; ++k) {
        if (row.index[k] <= row.index[i]) {
          information_(row.index[i], row.index[k]) += row.derivative[i] * row.derivative[k];
        }
      }
    }
  }

  // What a pixel changes by with the unknowns.
  SparseRow row_of(const Coverage& coverage, const LevelWeights& w, double contrast) const {
    SparseRow row;
    for (int i = 0; i < Shape::kSize; ++i) row.put(i, contrast * coverage.by_shape[static_cast<std::size_t>(i)]);
    row.put(Shape::kSize, contrast * coverage.by_blur);
    constexpr int kLevels = Shape::kSize + 1;
    const double uncovered = 1.0 - coverage.share;
    if (allowed_ == Levels::kEven) {
      row.put(kLevels, coverage.share);
      row.put(kLevels + 1, uncovered);
      return row;
    }
    const int of_outside = kLevels + parameters_.levels_around;
    row.put(kLevels + w.first, coverage.share * (1.0 - w.of_second));
    row.put(kLevels + w.second, coverage.share * w.of_second);
    row.put(of_outside + w.first, uncovered * (1.0 - w.of_second));
    row.put(of_outside + w.second, uncovered * w.of_second);
    return row;
  }

  void add_to_block(const Coverage& coverage, double contrast, double residual, BlockSums& block) const {
    const double by_move = contrast * coverage.by_distance;
    block.count += 1.0;
    block.squares += residual * residual;
    block.score += residual * by_move;
    block.information += by_move * by_move;
    block.contrast += contrast;
    constexpr double kBeyondBlur = 0.005;  // share of a pixel
    if (coverage.share > kBeyondBlur && coverage.share < 1.0 - kBeyondBlur) return;
    const std::size_t side = coverage.share > 0.5 ? 1 : 0;
    block.beyond[side] += residual;
    block.beyond_count[side] += 1.0;
  }

  // By how much more the outline's place scatters than independent pixels of that variance explain: the inverse of the
  // share of them that counts. 1 where chance explains it.
  double roughness(double variance) const {
    const StretchSums single = sums_over_stretches(1);
    if (!(single.left > 0.0)) return 1.0;
    const double free_blocks = static_cast<double>(single.count) * single.left / single.information;
    if (!(single.squares > explained_by_chance(free_blocks) * variance * single.left)) return 1.0;
    const auto window = static_cast<std::size_t>(std::ceil(parameters_.correlated_px / parameters_.block_px));
    const StretchSums sums = sums_over_stretches(window);
    if (!(sums.left > 0.0)) return single.squares / (variance * single.left);
    const double stretches = static_cast<double>(sums.count) / static_cast<double>(window);
    // Of stretches that err as a whole it takes one for each of the shape's parameters.
    constexpr double kLeastFree = 0.2;
    const double free_of_whole = std::max(kLeastFree, 1.0 - Shape::kSize / stretches);
    return std::max(1.0, sums.squares / (variance * sums.information * free_of_whole));
  }

  // Over stretches of `window` blocks each of the outline, of which all are used.
  struct StretchSums {
    std::size_t count = 0;
    double squares = 0.0;      // of how far each would move the outline
    double information = 0.0;  // what is expected of them, per variance of independent pixels, about the truth
    double left = 0.0;         // and about the fit
  };
  StretchSums sums_over_stretches(std::size_t window) const {
    StretchSums sums;
    const std::size_t n = blocks_.size();
    Eigen::VectorXd gradient(information_.rows());
    for (std::size_t first = 0; first < n; ++first) {
      BlockSums stretch;
      gradient.setZero();
      bool whole = true;
      for (std::size_t k = first; k < first + window; ++k) {
        const BlockSums& block = blocks_[k % n];
        whole = whole && about_.used[k % n] && block.information > 0.0;
        stretch.score += block.score;
        stretch.information += block.information;
        gradient += gradients_.col(static_cast<Eigen::Index>(k % n));
      }
      if (!whole) continue;
      ++sums.count;
      sums.squares += stretch.score * stretch.score;
      sums.information += stretch.information;
      sums.left += stretch.information - gradient.dot(solver_.solve(gradient));
    }
    return sums;
  }

  // Of a pixel: the median over the blocks.
  double robust_variance() const {
    std::vector<double> variances;
    for (const BlockSums& block : blocks_) {
      if (block.count > 0.0) variances.push_back(block.squares / block.count);
    }
    if (variances.empty()) return 1.0;
    const auto middle = variances.begin() + static_cast<std::ptrdiff_t>(variances.size() / 2);
    std::nth_element(variances.begin(), middle, variances.end());
    return std::max(*middle, std::pow(parameters_.min_noise, 2));
  }

  const ContourFitParameters& parameters_;
  Shape shape_;
  ContourPixels about_;
  Eigen::VectorXd inside_;  // levels around
  Eigen::VectorXd outside_;
  double blur_ = 0.0;
  Levels allowed_ = Levels::kEven;
  Eigen::MatrixXd information_;  // lower half
  Eigen::LDLT<Eigen::MatrixXd> solver_;
  std::vector<BlockSums> blocks_;
  Eigen::MatrixXd gradients_;                     // of each block in a column: how its score falls with the unknowns
  std::vector<typename Shape::Vector> outwards_;  // how places on the outline move with the shape's parameters
  Totals totals_;
};

// With even levels, as far as the pixels agree to that: each that may vary costs certainty.
template <class Shape>
bool settle(ContourProblem<Shape>& problem, const Shape& start) {
  if (problem.iterate() && !problem.levels_vary()) return true;
  problem.begin(start, Levels::kVaried);
  return problem.iterate();
}

}  // namespace

template <class Shape>
std::optional<FittedContour<Shape>> fit_contour(const PlaneImage& contrast, const Shape& start,
                                                const ContourFitParameters& parameters) {
  if (contrast.empty() || !start.is_sane()) return std::nullopt;
  ContourProblem<Shape> problem(contrast, start, parameters);
  if (!settle(problem, start)) return std::nullopt;
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds && problem.drop_outliers() > 0; ++round) {
    if (!problem.enough_is_left() || !problem.iterate()) return std::nullopt;
  }
  if (!problem.enough_is_left()) return std::nullopt;
  return problem.result();
}

template std::optional<FittedContour<QuadContour>> fit_contour(const PlaneImage&, const QuadContour&,
                                                               const ContourFitParameters&);
template std::optional<FittedContour<EllipseContour>> fit_contour(const PlaneImage&, const EllipseContour&,
                                                                  const ContourFitParameters&);

}  // namespace markservo::target_locator
