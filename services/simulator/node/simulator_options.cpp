#include "services/simulator/node/simulator_options.hpp"

#include "common/bus/number_options.hpp"
#include "services/simulator/settings/settings.hpp"
#include "services/simulator/time/awaited_channels.hpp"

namespace markservo::simulator {

void add_simulator_options(CLI::App& app, SimulatorOptions& options) {
  app.add_option("--scene", options.scene_file, "The world around the robot")->capture_default_str();
  app.add_option("--seed", options.seed, "Seed of all that is random")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  app.add_option("--set", options.assignments,
                 "A setting, name=value, repeatable (--list-settings explains them): " + setting_names());
  app.add_flag("--lockstep", options.lockstep,
               "Stand still until every awaited channel has answered the frame or odometry");
  app.add_option("--wait-for", options.wait_for, "Channels awaited in lockstep")
      ->delimiter(',')
      ->check(CLI::IsMember(answering_channels()))
      ->capture_default_str();
  app.add_option("--lockstep-timeout", options.lockstep_timeout_s,
                 "Wait for answers at most this long, s; then the run is invalid")
      ->check(bus::Within(0.1, 3600.0))
      ->capture_default_str();
  app.add_option("--encoding", options.encoding, "raw, jpeg, or auto: raw where the network's buffers hold it")
      ->check(CLI::IsMember({"auto", "raw", "jpeg"}))
      ->capture_default_str();
  app.add_option("--jpeg-quality", options.jpeg_quality, "1 to 100")->check(CLI::Range(1, 100))->capture_default_str();
  add_picture_options(app, options.pictures);
  app.add_flag("--list-settings", options.list_settings, "Print all settings with values and meaning and exit")
      ->configurable(false);
}

}  // namespace markservo::simulator
