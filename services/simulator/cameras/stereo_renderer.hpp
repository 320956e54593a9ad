#pragma once

// Draws what both cameras see, without GPU or display: EGL without a surface, 4 x multisampling. One per thread.

#include <memory>

#include "services/simulator/cameras/image_pair.hpp"

namespace markservo::simulator {

class Physics;

class StereoRenderer {
 public:
  // Throws std::runtime_error if there is no OpenGL through EGL.
  StereoRenderer();
  ~StereoRenderer();
  StereoRenderer(const StereoRenderer&) = delete;
  StereoRenderer& operator=(const StereoRenderer&) = delete;

  // Draws the world as it was at World::truth() last. The first picture of one takes some 0.2 s more: shapes and
  // textures are taken over.
  ImagePair render(const Physics& world);

 private:
  struct Context;
  std::unique_ptr<Context> context_;
};

}  // namespace markservo::simulator
