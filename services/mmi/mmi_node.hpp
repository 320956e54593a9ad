#pragma once

#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "common/bus/service.hpp"
#include "common/robot/robot_description.hpp"
#include "services/mmi/live_source_node.hpp"
#include "services/mmi/mmi_options.hpp"

namespace markservo::mmi {

// Shows a robot, or a log of one, to browsers.
class MmiNode final : public bus::Service {
 public:
  void add_options(CLI::App& app) override { mmi::add_options(app, options_); }
  void configure(const std::string& robot_file) override;
  std::optional<int> run_alone(const std::string& robot) override;
  void start(bus::Bus& bus) override;
  void run(bus::Bus& bus) override;

 private:
  void show_log(const std::string& robot);
  // `own`: what the hello of this source has besides.
  std::string hello(const robot::RobotDescription& robot, const nlohmann::ordered_json& own) const;

  MmiOptions options_;
  ListenPlace place_;
  std::string token_;
  std::string command_token_;  // empty: nobody commands
  std::string robot_file_;
  robot::RobotDescription robot_;
  std::optional<LiveSourceNode> live_;
};

}  // namespace markservo::mmi
