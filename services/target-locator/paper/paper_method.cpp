#include "services/target-locator/paper/paper_method.hpp"

namespace markservo::target_locator {

Location locate_as_in_the_paper(const MarkObservation& observation, const geometry::StereoCamera& camera,
                                const PaperParameters& parameters, int min_matches, const StereoPatch& patch,
                                const std::vector<Feature>& features) {
  Location location;
  const Gradients right = sobel_gradients(patch.right);
  location.matches =
      match_as_in_the_paper(features, patch.left_gradients, right, observation.left, observation.right, parameters);
  const PaperPosition position = position_as_in_the_paper(location.matches, camera);
  location.status = Status::kTooFewMatches;
  if (position.num_points < min_matches) return location;
  location.status = Status::kLocated;
  location.cue = Cue::kTexture;
  location.p_C = position.p_C;
  location.covariance = position.covariance;
  return location;
}

}  // namespace markservo::target_locator
