#pragma once

// Our own chain from an image pair to the marks' places, as the two services run it but without the bus between them;
// the whole, and its stages one by one.

#include <cstddef>
#include <vector>

#include "common/robot/robot_description.hpp"
#include "services/mark-detector/mark_detector.hpp"
#include "services/target-locator/mark_locator.hpp"
#include "tests/scenes/stereo_scene.hpp"

namespace markservo::bench {

enum class Scan { kWholeImage, kTracked };

class Ours {
 public:
  struct Result {
    const mark_detector::Output& detection;           // until the next run
    std::vector<target_locator::Location> locations;  // one a mark
  };

  Ours(const std::vector<robot::MarkDescription>& marks, const geometry::StereoCamera& camera, Scan scan);

  // The whole chain.
  Result run(const scenes::StereoPair& pair);
  // Its two services.
  const mark_detector::Output& detect(const scenes::StereoPair& pair);
  std::vector<target_locator::Location> locate(const mark_detector::Output& detection);

  // The detector's parts, with what each needs from the one before it.
  mark_detector::LumaShift equalise(const scenes::StereoPair& pair) const;
  void classify(const scenes::StereoPair& pair, const mark_detector::LumaShift& shift);
  std::size_t label();  // what was classified last; the number of blobs

 private:
  std::vector<robot::MarkDescription> marks_;
  geometry::StereoCamera camera_;
  mark_detector::Parameters parameters_;
  mark_detector::MarkDetector detector_;
  mark_detector::State state_;
  target_locator::LocatorParameters locator_;
  target_locator::LocatorWorkspace work_;
  std::vector<mark_detector::ColourRule> rules_;
  std::vector<mark_detector::FrameRule> frame_rules_;
  mark_detector::MajorityFilter filter_;
  mark_detector::BlobFinder finder_;
  mark_detector::BlobList blobs_;
  imaging::BitMask clean_;
  std::vector<imaging::BitMask> left_masks_;
  std::vector<imaging::BitMask> right_masks_;
};

}  // namespace markservo::bench
