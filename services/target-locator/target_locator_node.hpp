#pragma once

// Reads MARK_DETECTION; writes one TARGET_POSE and one STEREO_MATCHES for each that is worked on.

#include <map>
#include <markservo/channels.hpp>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/service.hpp"
#include "services/target-locator/mark_locator.hpp"

namespace markservo::target_locator {

class TargetLocatorNode final : public bus::Service {
 public:
  void add_options(CLI::App& app) override;
  void configure(const std::string& robot_file) override;
  void start(bus::Bus& bus) override;

 private:
  // What robot.yaml or --surface says of a mark.
  struct KnownMark {
    Surface surface = Surface::kPlane;
    double size = 0.0;  // m; 0: unknown
  };

  void on_detection(const MarkDetection& detection);

  std::string method_ = "refined";
  std::vector<std::string> surface_texts_;
  LocatorParameters parameters_;
  LocatorWorkspace work_;
  std::map<std::string, KnownMark> marks_;
  std::optional<bus::Publisher<TargetPose>> poses_;
  std::optional<bus::Publisher<StereoMatches>> matches_;
  bool told_of_dropped_marks_ = false;
};

}  // namespace markservo::target_locator
