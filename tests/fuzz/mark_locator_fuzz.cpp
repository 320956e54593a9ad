// The locator's core: any two views of a mark and any camera, by both methods and for both kinds of surface.

#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdint>

#include "services/target-locator/mark_locator.hpp"
#include "tests/fuzz/numbers.hpp"
#include "tests/fuzz/printed_mark.hpp"
#include "tests/fuzz/require.hpp"

namespace markservo::target_locator {
namespace {

using fuzz::require;

LocatorParameters take_parameters(FuzzedDataProvider& data) {
  LocatorParameters parameters;
  if (data.ConsumeIntegralInRange(0, 3) == 3) parameters.method = Method::kPaper;
  if (data.ConsumeIntegralInRange(0, 3) < 3) return parameters;
  parameters.features.max_features = data.ConsumeIntegralInRange(6, 200);
  parameters.min_matches = data.ConsumeIntegralInRange(3, 40);
  parameters.free_surface.search.disparity_min = fuzz::number(data, 0.0, -500.0, 500.0);
  parameters.free_surface.search.disparity_max = fuzz::number(data, 0.0, -500.0, 500.0);
  parameters.paper.window = data.ConsumeFloatingPointInRange(0.01, 4.0);
  return parameters;
}

geometry::StereoCamera take_camera(FuzzedDataProvider& data) {
  return {fuzz::number(data, 784.0, 1.0, 1e4),  fuzz::number(data, 784.0, 1.0, 1e4),
          fuzz::number(data, 319.5, -1e3, 1e3), fuzz::number(data, 319.5, -1e3, 1e3),
          fuzz::number(data, 239.5, -1e3, 1e3), fuzz::number(data, 0.065, 1e-3, 1.0)};
}

void check_location(const Location& location, const LocatorParameters& parameters) {
  require(location.matches.size() <= static_cast<std::size_t>(parameters.features.max_features),
          "there are no more matches than features");
  if (location.status != Status::kLocated) {
    require(location.cue == Cue::kNone && location.p_C.isZero(0.0) && location.covariance.isZero(0.0) &&
                location.normal_C.isZero(0.0),
            "what is not located has no position");
    return;
  }
  require(location.p_C.allFinite(), "a position is finite");
  require(location.p_C.y() > 0.0, "what is located lies in front");
  require(location.covariance.allFinite(), "a covariance is finite");
  require(location.normal_C.isZero(0.0) || std::abs(location.normal_C.norm() - 1.0) < 1e-6, "a normal has length 1");
  require(location.cue != Cue::kNone, "a position has a cue");
  require(location.cue != Cue::kTexture || location.matches.size() >= static_cast<std::size_t>(parameters.min_matches),
          "a position by texture has the fewest matches");
  for (const Match& match : location.matches) {
    require(std::isfinite(match.u_left) && std::isfinite(match.v_left) && std::isfinite(match.u_right) &&
                std::isfinite(match.v_right) && std::isfinite(match.residual),
            "a match is finite");
  }
  const double largest = location.covariance.cwiseAbs().maxCoeff();
  require(largest > 0.0, "no measurement is exact");
  require((location.covariance - location.covariance.transpose()).cwiseAbs().maxCoeff() <= 1e-9 * largest,
          "a covariance is symmetric");
  // Scaled, so that neither tiny nor huge ones leave the range of doubles.
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(location.covariance / largest);
  require(solver.eigenvalues().minCoeff() >= -1e-9, "a covariance is positive semidefinite");
}

void run(FuzzedDataProvider& data) {
  const LocatorParameters parameters = take_parameters(data);
  const geometry::StereoCamera camera = take_camera(data);
  fuzz::PrintedMark mark;
  fuzz::print_mark(data, data.ConsumeIntegralInRange(0, 3) < 3, mark);
  check_location(locate_mark(mark.observation, camera, parameters), parameters);
}

}  // namespace
}  // namespace markservo::target_locator

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  FuzzedDataProvider data(bytes, size);
  markservo::target_locator::run(data);
  return 0;
}
