#include "services/simulator/cameras/cameras.hpp"

#include <utility>

#include "services/simulator/cameras/image_effects.hpp"
#include "services/simulator/world/simulation.hpp"

namespace markservo::simulator {

ImagePair Cameras::show(const Simulation& simulation) {
  ImagePair images = renderer_.render(simulation.world());
  apply_effects(simulation.effects(), simulation.noise_seed_of(0), images.left);
  apply_effects(simulation.effects(), simulation.noise_seed_of(1), images.right);
  return faults_.apply(simulation.settings().faults, std::move(images));
}

}  // namespace markservo::simulator
