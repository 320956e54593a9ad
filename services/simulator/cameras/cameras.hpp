#pragma once

#include "services/simulator/cameras/image_effects.hpp"
#include "services/simulator/cameras/image_pair.hpp"
#include "services/simulator/cameras/stereo_renderer.hpp"
#include "services/simulator/faults/sensor_faults.hpp"

namespace markservo::simulator {

// The robot's cameras: what they show of the world, with all that real ones do to a picture. One per thread. Throws
// std::runtime_error at its construction if there is no OpenGL through EGL.
class Cameras {
 public:
  // The world as it was at World::truth() last, with these effects and this noise; a camera that `faults` freezes shows
  // what it has shown first.
  ImagePair show(const Physics& world, const ImageEffects& effects, const NoiseSeeds& noise,
                 const FaultSettings& faults);

 private:
  StereoRenderer renderer_;
  SensorFaults faults_;
};

}  // namespace markservo::simulator
