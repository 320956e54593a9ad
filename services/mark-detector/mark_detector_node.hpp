#pragma once

// Reads STEREO_FRAME, writes MARK_DETECTION: one for each frame that is worked on. Learns a mark's colour for
// LEARN_REQUEST. Or, without a bus, looks at a picture or learns a colour from it.

#include <array>
#include <markservo/channels.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/service.hpp"
#include "common/frames/jpeg_decoder.hpp"
#include "services/mark-detector/learning/learn_options.hpp"
#include "services/mark-detector/learning/learning_node.hpp"
#include "services/mark-detector/mark_detector.hpp"
#include "services/mark-detector/picture/picture_options.hpp"

namespace markservo::mark_detector {

class MarkDetectorNode final : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  std::optional<int> run_alone(const std::string& robot) override;
  void start(bus::Bus& bus) override;

 private:
  void on_frame(const StereoFrame& frame);
  LearningParameters learning_parameters() const;
  bool adopt(const std::string& mark, const robot::ColourInterval& colour);

  bool no_equalise_ = false;
  bool no_adapt_ = false;
  std::int64_t patch_budget_ = 0;  // bytes; 0: grows with the patch limit
  std::vector<std::string> mark_texts_;
  std::string robot_file_;
  PictureOptions picture_;
  LearnOptions learn_;

  Parameters parameters_;
  std::vector<robot::MarkDescription> marks_;  // that are looked for
  std::optional<MarkDetector> detector_;
  std::optional<State> state_{std::in_place};
  std::array<frames::JpegDecoder, 2> jpeg_decoders_;  // left, right: both at once
  std::optional<bus::Publisher<MarkDetection>> publisher_;
  LearningNode learning_;
};

}  // namespace markservo::mark_detector
