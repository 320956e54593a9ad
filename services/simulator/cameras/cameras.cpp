#include "services/simulator/cameras/cameras.hpp"

#include <utility>

namespace markservo::simulator {

ImagePair Cameras::show(const Physics& world, const ImageEffects& effects, const NoiseSeeds& noise,
                        const FaultSettings& faults) {
  ImagePair images = renderer_.render(world);
  apply_effects(effects, noise.left, images.left);
  apply_effects(effects, noise.right, images.right);
  return faults_.apply(faults, std::move(images));
}

}  // namespace markservo::simulator
