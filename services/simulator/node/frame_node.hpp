#pragma once

// The simulated cameras on the bus: STEREO_FRAME out.

#include <cstdint>
#include <markservo/channels.hpp>

#include "common/bus/bus.hpp"
#include "services/simulator/cameras/cameras.hpp"
#include "services/simulator/world/simulation.hpp"

namespace markservo::simulator {

// What the cameras show of the frame exposed last.
ImagePair exposed_frame(const Simulation& simulation, Cameras& cameras);

class FrameNode {
 public:
  // `simulation` and `cameras` outlive this. `jpeg_quality` 1 to 100; 0: raw.
  FrameNode(bus::Bus& bus, const Simulation& simulation, Cameras& cameras, int jpeg_quality);

  // Draws and sends the frame exposed now, unless it is one of the lost ones.
  void publish();

  std::int64_t session() const { return frames_.session(); }

 private:
  const Simulation* simulation_;
  Cameras* cameras_;
  int jpeg_quality_;
  bus::Publisher<StereoFrame> frames_;
};

}  // namespace markservo::simulator
