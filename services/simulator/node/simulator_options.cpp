#include "services/simulator/node/simulator_options.hpp"

#include "common/bus/options.hpp"
#include "services/simulator/settings/settings.hpp"
#include "services/simulator/time/awaited_channels.hpp"

namespace markservo::simulator {

void add_simulator_options(CLI::App& app, SimulatorOptions& options) {
  const bus::Options add(app);
  add.option("--scene", options.scene_file, "The world around the robot").environment("MARKSERVO_SCENE").show_default();
  add.option("--seed", options.seed, "Seed of all that is random").not_negative().show_default();
  add.option("--set", options.assignments,
             "A setting, name=value, repeatable (--list-settings explains them): " + setting_names());
  add.flag("--lockstep", options.lockstep,
           "Stand still until every awaited channel has answered the frame or odometry");
  add.option("--wait-for", options.wait_for, "Channels awaited in lockstep")
      .delimiter(',')
      .one_of(answering_channels())
      .show_default();
  add.option("--lockstep-timeout", options.lockstep_timeout_s,
             "Wait for answers at most this long, s; then the run is invalid")
      .within(0.1, 3600.0)
      .show_default();
  add.option("--encoding", options.encoding, "raw, jpeg, or auto: raw where the network's buffers hold it")
      .one_of({"auto", "raw", "jpeg"})
      .show_default();
  add.option("--jpeg-quality", options.jpeg_quality, "1 to 100").in_range(1, 100).show_default();
  add_picture_options(app, options.pictures);
  add.flag("--list-settings", options.list_settings, "Print all settings with values and meaning and exit")
      .not_in_config();
}

}  // namespace markservo::simulator
