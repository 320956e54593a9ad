#pragma once

// Draws what both cameras see, without GPU or display: EGL without a surface, 4 x multisampling. One per thread.

#include <memory>
#include <opencv2/core.hpp>

#include "services/simulator/world.hpp"

namespace markservo::simulator {

struct ImagePair {
  cv::Mat left;   // CV_8UC3, blue first, rows from the top
  cv::Mat right;  // likewise
};

class StereoRenderer {
 public:
  // Throws std::runtime_error if there is no OpenGL through EGL.
  StereoRenderer();
  ~StereoRenderer();
  StereoRenderer(const StereoRenderer&) = delete;
  StereoRenderer& operator=(const StereoRenderer&) = delete;

  // Takes over a world's shapes and textures; needed once for each new World.
  void load(const World& world);

  // Draws the loaded world as it was at its last truth().
  ImagePair render(const World& world);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace markservo::simulator
