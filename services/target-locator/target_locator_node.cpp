#include "services/target-locator/target_locator_node.hpp"

#include <markservo/MarkDetection.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/TargetPose.hpp>

#include "common/bus/options.hpp"
#include "common/logging/log.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/robot/robot_description.hpp"
#include "services/target-locator/pose_message.hpp"

namespace markservo::target_locator {

void TargetLocatorNode::add_options(CLI::App& app) {
  const bus::Options add(app);
  add.option("--method", method_, "refined: sub-pixel, checked; paper: the paper's matching as it stands")
      .one_of({"refined", "paper"})
      .show_default();
  add.option("--surface", surface_texts_, "NAME=plane or NAME=free: what the mark is, instead of robot.yaml's word");
  add.option("--max-features", parameters_.features.max_features, "Most feature points per mark")
      .in_range(6, 100000)
      .show_default();
  add.option("--min-matches", parameters_.min_matches, "Fewest matches that carry a position")
      .in_range(3, 1000)
      .show_default();
  add.option("--disparity-min", parameters_.free_surface.search.disparity_min,
             "Free surfaces: smallest disparity looked for, px; with --disparity-max, else the boxes tell")
      .show_default();
  add.option("--disparity-max", parameters_.free_surface.search.disparity_max,
             "Free surfaces: largest disparity looked for, px")
      .show_default();
  add.option("--paper-window", parameters_.paper.window,
             "--method paper: side of the search window over the side of the mark's box (a of eq. 3)")
      .within(0.01, 4.0)
      .show_default();
}

void TargetLocatorNode::configure(const std::string& robot_file) {
  parameters_.method = method_ == "paper" ? Method::kPaper : Method::kRefined;
  const SearchParameters& search = parameters_.free_surface.search;
  if (search.disparity_min != search.disparity_max && !(search.disparity_min < search.disparity_max)) {
    throw ConfigurationError("--disparity-max: " + std::to_string(search.disparity_max) +
                             " px; allowed: above --disparity-min, " + std::to_string(search.disparity_min) + " px");
  }
  const robot::RobotDescription description = robot::load_robot_description(robot_file);
  for (const auto& mark : description.marks) {
    marks_[mark.name] = {mark.surface == robot::MarkSurface::kFree ? Surface::kFree : Surface::kPlane, mark.size};
  }
  for (const std::string& text : surface_texts_) {
    if (text.empty()) continue;  // as --print-config writes an unset option
    const auto equals = text.rfind('=');
    const std::string word = equals == std::string::npos ? "" : text.substr(equals + 1);
    if (equals == 0 || (word != "plane" && word != "free")) {
      throw ConfigurationError("--surface '" + text + "': allowed: NAME=plane or NAME=free");
    }
    marks_[text.substr(0, equals)].surface = word == "free" ? Surface::kFree : Surface::kPlane;
  }
}

void TargetLocatorNode::start(bus::Bus& bus) {
  poses_.emplace(bus.advertise(channels::kTargetPose));
  matches_.emplace(bus.advertise(channels::kStereoMatches));
  bus.on_latest(channels::kMarkDetection, [this](const MarkDetection& detection) { on_detection(detection); });
  bus.need(channels::kMarkDetection);
}

void TargetLocatorNode::on_detection(const MarkDetection& detection) {
  const geometry::StereoCamera camera = camera_of(detection.calibration);
  auto pose = answer_to<TargetPose>(detection);
  auto matches = answer_to<StereoMatches>(detection);
  for (const DetectedMark& mark : detection.marks) {
    const auto known = marks_.find(mark.name);
    const KnownMark described = known == marks_.end() ? KnownMark{} : known->second;
    const Location location =
        locate_mark(observation_of(mark, described.surface, described.size), camera, parameters_, work_);
    pose.marks.push_back(located_mark(mark, location));
    matches.marks.push_back(matches_of(mark, location));
  }
  matches.num_marks = static_cast<std::int32_t>(matches.marks.size());
  const int dropped = fit_into_packet(pose);
  if (dropped > 0 && !told_of_dropped_marks_) {
    told_of_dropped_marks_ = true;
    logging::warn("TARGET_POSE: the last {} of {} marks do not fit a packet of {} bytes and are left out", dropped,
                  detection.marks.size(), kMaxPoseBytes);
  }
  poses_->publish(pose);
  matches_->publish(matches);
}

}  // namespace markservo::target_locator
