#include "services/simulator/node/frame_node.hpp"

#include <markservo/StereoFrame.hpp>

#include "services/simulator/messages/frame_messages.hpp"

namespace markservo::simulator {

ImagePair exposed_frame(const Simulation& simulation, Cameras& cameras) {
  return cameras.show(simulation.world().physics(), simulation.effects(), simulation.noise(),
                      simulation.settings().faults);
}

FrameNode::FrameNode(bus::Bus& bus, const Simulation& simulation, Cameras& cameras, int jpeg_quality)
    : simulation_(&simulation),
      cameras_(&cameras),
      jpeg_quality_(jpeg_quality),
      frames_(bus.advertise(channels::kStereoFrame)) {}

void FrameNode::publish() {
  if (simulation_->dropped()) {
    frames_.skip();
    return;
  }
  StereoFrame frame = frame_message(simulation_->robot().cameras, simulation_->settings().calibration,
                                    exposed_frame(*simulation_, *cameras_), jpeg_quality_);
  frame.utime = simulation_->utime();
  frames_.publish(frame);
}

}  // namespace markservo::simulator
