#pragma once

#include <cstdint>
#include <markservo/channels.hpp>
#include <string>
#include <vector>

#include "services/simulator/node/picture_options.hpp"

namespace CLI {
class App;
}

namespace markservo::simulator {

struct SimulatorOptions {
  std::string scene_file = "config/scenes/shelf.yaml";
  std::int64_t seed = 1;
  std::vector<std::string> assignments;  // of settings, "name=value"
  bool lockstep = false;
  std::vector<std::string> wait_for = {channels::kJointCommand.name};
  double lockstep_timeout_s = 5.0;
  std::string encoding = "auto";  // or "raw", "jpeg"
  int jpeg_quality = 90;
  PictureOptions pictures;
  bool list_settings = false;
};

void add_simulator_options(CLI::App& app, SimulatorOptions& options);

}  // namespace markservo::simulator
