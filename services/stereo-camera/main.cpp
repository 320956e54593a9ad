// stereo-camera: publishes STEREO_FRAME from two cameras, one side-by-side camera, videos or pictures.

#include "common/bus/service.hpp"
#include "services/stereo-camera/stereo_camera_node.hpp"

int main(int argc, char** argv) {
  markservo::stereo_camera::StereoCameraNode node;
  return markservo::bus::run_service(
      {"stereo-camera", "Cameras, videos or pictures in; rectified colour pairs out on STEREO_FRAME"}, node, argc,
      argv);
}
