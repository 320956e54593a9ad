#pragma once

#include "services/simulator/cameras/image_pair.hpp"
#include "services/simulator/cameras/stereo_renderer.hpp"
#include "services/simulator/faults/sensor_faults.hpp"

namespace markservo::simulator {

class Simulation;

// The robot's cameras: what they show of the world, with all that real ones do to a picture. One per thread. Throws
// std::runtime_error at its construction if there is no OpenGL through EGL.
class Cameras {
 public:
  // The frame that was exposed last, of the world as it was at its last truth().
  ImagePair show(const Simulation& simulation);

 private:
  StereoRenderer renderer_;
  SensorFaults faults_;
};

}  // namespace markservo::simulator
