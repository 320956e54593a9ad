#include "services/mark-detector/mark_detector_node.hpp"

#include <algorithm>
#include <future>
#include <markservo/MarkDetection.hpp>
#include <markservo/StereoFrame.hpp>
#include <set>
#include <utility>

#include "common/bus/options.hpp"
#include "common/frames/frame_side.hpp"
#include "common/logging/log.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/mark-detector/colour/colour_overlap.hpp"
#include "services/mark-detector/detection_message.hpp"
#include "services/mark-detector/mark_option.hpp"
#include "services/mark-detector/picture/picture.hpp"

namespace markservo::mark_detector {
void MarkDetectorNode::add_options(CLI::App& app) {
  const bus::Options add(app);
  add.flag("--no-equalise", no_equalise_, "Take images as they are, without histogram equalisation");
  add.flag("--no-adapt", no_adapt_, "Keep the marks' colour intervals as they are, whatever the light does");
  add.option("--mark", mark_texts_,
             "Look for this instead of the robot's marks: NAME=hue_min:hue_max:sat_min:sat_max:val_min:val_max"
             "[:plane|:free|:ball], hue in degrees (wraps), saturation and value 0 to 1");
  add.option("--min-area", parameters_.views.min_area, "Smallest blob that can be a mark, px")
      .in_range(1, 1'000'000'000)
      .show_default();
  add.option("--chroma-min", parameters_.chroma_min, "Least difference of the channels that tells a colour, levels")
      .in_range(0, 255)
      .show_default();
  add.option("--row-tolerance", parameters_.views.selection.row_tolerance,
             "How far a mark's rows may differ between the images, px")
      .within(0.0, 1e6)
      .show_default();
  add.option("--memory-frames", parameters_.search.memory_frames,
             "Frames for which the place of an unseen mark is remembered")
      .in_range(0, 1'000'000'000)
      .show_default();
  add.option("--patch-limit", parameters_.patch.limit, "Largest patch, px a side; larger marks are averaged down")
      .in_range(1, 16384)
      .show_default();
  add.option("--patch-budget", patch_budget_,
             "All patches of a pair together, bytes; 0: 131072, growing with the square of a --patch-limit above 128")
      .in_range(0, 1'000'000'000)
      .show_default();

  picture_.add_to(app);
  learn_.add_to(app);
  learning_.add_to(app);
}

void MarkDetectorNode::configure(const std::string& robot_file) {
  learn_.check();
  if (learn_.wanted() && (picture_.wanted() || !mark_texts_.empty())) {
    throw ConfigurationError("--learn: with --image or --mark; allowed: a mark of --robot-file, without them");
  }
  robot_file_ = robot_file;
  marks_.clear();
  std::set<std::string> names;
  for (const std::string& text : mark_texts_) {
    marks_.push_back(parse_mark(text));
    if (!names.insert(marks_.back().name).second) {
      throw ConfigurationError("--mark '" + text + "': named twice; allowed: a name of its own for each mark");
    }
  }
  if (marks_.size() > robot::kMaxMarks)
    throw ConfigurationError("--mark: given more than 8 times; allowed: 1 to 8 marks");
  if (marks_.empty()) marks_ = robot::load_robot_description(robot_file).marks;
  picture_.check();
  parameters_.equalise = !no_equalise_;
  parameters_.adapt = !no_adapt_;
  if (patch_budget_ > 0) {
    parameters_.patch.budget = patch_budget_;
  } else {
    const PatchParameters usual;
    const std::int64_t factor = std::max<std::int64_t>(usual.limit, parameters_.patch.limit);
    parameters_.patch.budget = usual.budget * factor * factor / (static_cast<std::int64_t>(usual.limit) * usual.limit);
  }
  for (const std::string& line : told_of_overlaps(marks_)) logging::warn("{}", line);
  detector_.emplace(marks_, parameters_);
}

std::optional<int> MarkDetectorNode::run_alone(const std::string& /*robot*/) {
  if (learn_.wanted()) {
    learn_.run(robot_file_, learning_parameters(), parameters_);
    return bus::kExitStopped;
  }
  if (!picture_.wanted()) return std::nullopt;
  picture_.run(*detector_, parameters_.equalise);
  return bus::kExitStopped;
}

void MarkDetectorNode::start(bus::Bus& bus) {
  publisher_.emplace(bus.advertise(channels::kMarkDetection));
  bus.on_latest(channels::kStereoFrame, [this](const StereoFrame& frame) { on_frame(frame); });
  bus.need(channels::kStereoFrame);
  LearningSettings settings{robot_file_, learning_parameters(), parameters_, ""};
  if (!mark_texts_.empty()) settings.obstacle = "mark-detector has marks of its own; allowed: without --mark";
  learning_.start(bus, std::move(settings),
                  [this](const std::string& mark, const robot::ColourInterval& colour) { return adopt(mark, colour); });
}

// As the detector sees.
LearningParameters MarkDetectorNode::learning_parameters() const {
  LearningParameters learning;
  learning.equalise = parameters_.equalise;
  learning.chroma_min = parameters_.chroma_min;
  return learning;
}

bool MarkDetectorNode::adopt(const std::string& mark, const robot::ColourInterval& colour) {
  const auto renewed =
      std::find_if(marks_.begin(), marks_.end(), [&mark](const auto& one) { return one.name == mark; });
  if (renewed == marks_.end()) return false;
  renewed->colour = colour;
  detector_.emplace(marks_, parameters_);
  state_.emplace();
  return true;
}

void MarkDetectorNode::on_frame(const StereoFrame& frame) {
  learning_.observe(frame);
  // Unpacking a JPEG takes longer than finding the marks in it. Raw sides are not even copied: no thread for them.
  const auto policy = frame.encoding == StereoFrame::ENCODING_JPEG ? std::launch::async : std::launch::deferred;
  auto right_side =
      std::async(policy, [&] { return frames::picture_of(frame, frame.right, "right", jpeg_decoders_[1]); });
  const cv::Mat left = frames::picture_of(frame, frame.left, "left", jpeg_decoders_[0]);
  const cv::Mat right = right_side.get();
  Input input;
  input.left = view_of(left);
  input.right = view_of(right);
  const StereoCalibration& c = frame.calibration;
  input.stereo = geometry::StereoCamera{c.fx, c.fy, c.cx_left, c.cx_right, c.cy, c.baseline};
  MarkDetection detection = make_message(frame, detector_->step(input, *state_));
  publisher_->publish(detection);
}

}  // namespace markservo::mark_detector
