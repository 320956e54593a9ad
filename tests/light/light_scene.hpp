#pragma once

// A scene with the robot's marks and things of similar colours, exposed frame by frame under any light, while the view
// wanders over it. Where the marks are is known.

#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/mark_detector.hpp"
#include "tests/light/light_sequences.hpp"
#include "tests/scenes/stereo_scene.hpp"

namespace markservo::light {

// Where a mark's centre is, px.
struct MarkPlace {
  double u_left = 0.0;
  double v = 0.0;
  double u_right = 0.0;
  bool visible = false;  // wholly in both images, and not hidden
};

struct Frame {
  cv::Mat left;                  // 8-bit BGR
  cv::Mat right;                 // likewise
  std::vector<MarkPlace> marks;  // as configured

  mark_detector::Input input(const geometry::StereoCamera& camera) const;
};

class LightScene {
 public:
  // Rendered by `cameras` with `seed`; `sigma`: grey levels of noise.
  LightScene(const robot::CameraDescription& cameras, const std::vector<robot::MarkDescription>& marks, double sigma,
             unsigned seed);

  // Frame `index` of a sequence under a light, always the same. The frame's images are used again by the next call.
  const Frame& expose(const LightFrame& light, int index);

  const geometry::StereoCamera& camera() const { return camera_; }

 private:
  void add_similar_things(const std::vector<robot::MarkDescription>& marks, unsigned seed);
  void expose_view(const cv::Mat& view, const cv::Rect& window, const Gains& gains, cv::RNG& random,
                   cv::Mat& image) const;

  geometry::StereoCamera camera_;
  scenes::StereoPair bright_;     // without noise
  scenes::StereoPair hidden_;     // with something before each mark
  std::vector<MarkPlace> marks_;  // in the scene
  std::vector<int> mark_px_;      // edge
  cv::Mat3s noise_;
  unsigned seed_;
  Frame frame_;
};

}  // namespace markservo::light
