#include "services/mmi/mmi_node.hpp"

#include <sys/resource.h>
#include <unistd.h>

#include "common/bus/end_signals.hpp"
#include "common/logging/log.hpp"
#include "common/logs/log_files.hpp"
#include "common/reflection/message_json.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/mmi/log/log_source.hpp"
#include "services/mmi/log/recording_robot.hpp"
#include "services/mmi/scene/hello_json.hpp"
#include "services/mmi/scene/scene_json.hpp"
#include "services/mmi/site_node.hpp"
#include "services/mmi/web_loop_node.hpp"

namespace markservo::mmi {
namespace {

// Pictures for ten browsers are made and sent beside what moves the robot, which goes first.
constexpr int kNice = 10;

// Without stop devices nothing would ever have echoed: Stop would never end.
void check_stop_devices(const robot::RobotDescription& robot, const std::string& robot_file) {
  if (robot.stop_devices.empty()) {
    throw ConfigurationError(robot_file + ": stop_devices is empty; allowed: what moves, so that it can be stopped");
  }
}

}  // namespace

void MmiNode::configure(const std::string& robot_file) {
  robot_file_ = robot_file;
  place_ = listen_place(options_.listen);
  if (!options_.token_file.empty()) {
    token_ = read_token(options_.token_file);
  } else if (!is_private(place_)) {
    throw ConfigurationError("--listen " + options_.listen +
                             ": others reach it; allowed: a loopback address, a path, or with --token-file FILE");
  }
  if (options_.enable_commands != !options_.command_token_file.empty()) {
    throw ConfigurationError("--enable-commands and --command-token-file; allowed: both, or neither");
  }
  if (options_.enable_commands) {
    if (!options_.log.empty())
      throw ConfigurationError("--enable-commands: a log obeys nobody; allowed: without --log");
    command_token_ = command_token(options_.command_token_file);
  }
  if (options_.page.empty()) options_.page = default_page_folder();
  // A recording brings its own robot.
  if (options_.log.empty()) {
    robot_ = robot::load_robot_description(robot_file);
    check_stop_devices(robot_, robot_file);
  }
}

std::string MmiNode::hello(const robot::RobotDescription& robot, const nlohmann::ordered_json& own) const {
  nlohmann::ordered_json hello{{"type", "hello"}, {"protocol", kProtocol}, {"version", MARKSERVO_VERSION}};
  hello.update(own);
  hello.update(vocabulary_json());
  hello["stop_devices"] = robot.stop_devices;
  hello["update_at_least_every"] = kUpdateAtLeastEvery;
  hello["scene"] = scene_json(robot, options_.tag_field);
  std::string text = reflection::json_text(hello, -1);
  text.erase(text.rfind('}'));
  return text;
}

std::optional<int> MmiNode::run_alone(const std::string& robot) {
  if (options_.log.empty()) return std::nullopt;
  try {
    show_log(robot);
  } catch (const logs::LogFileError& error) {
    throw ConfigurationError(error.what());
  }
  return bus::kExitStopped;
}

void MmiNode::show_log(const std::string& robot) {
  RecordedRobot recorded = recorded_robot(options_.log);
  const bool is_own = recorded.description.has_value();
  if (!is_own) recorded.description = robot::load_robot_description(robot_file_);
  const std::string name = robot.empty() ? recorded.robot : robot;
  LogSource source(options_.log, name.empty() ? "" : name + "/", *recorded.description, options_.tag_field,
                   typed_command());
  const LogIndex& index = source.index();
  const nlohmann::ordered_json own{
      {"mode", "log"},
      {"robot", name},
      {"bus", options_.log},
      {"robot_file", {{"path", is_own ? recorded.path : robot_file_}, {"from", is_own ? "recording" : "option"}}},
      {"log",
       {{"path", options_.log},
        {"begin", std::to_string(index.begin())},
        {"end", std::to_string(index.end())},
        {"damaged", source.damaged()},
        {"note", recorded.note}}}};
  SiteNode site(source, hello(*recorded.description, own), PageFiles(options_.page), {options_.hosts, token_});
  bus::note_end_signals(true);
  serve(
      site, place_, [] { return Heard{}; },
      [&source] {
        source.read_on();
        return !bus::told_to_end();
      });
}

void MmiNode::start(bus::Bus& bus) {
  live_.emplace(robot_, options_.tag_field, typed_command(), command_token_);
  live_->start(bus);
}

void MmiNode::run(bus::Bus& bus) {
  // This thread's alone, on Linux: the one that hears the bus must keep up.
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
  const nlohmann::ordered_json own{{"mode", "live"},
                                   {"robot", bus.robot()},
                                   {"bus", bus.urls().in},
                                   {"robot_file", {{"path", robot_file_}, {"from", "option"}}}};
  PageFiles page(options_.page);
  if (!page.is_built()) logging::warn("there is no page in {}: build it with scripts/build, by npm", options_.page);
  SiteNode site(*live_, hello(robot_, own), std::move(page), {options_.hosts, token_});
  serve(
      site, place_,
      [&bus] {
        return Heard{bus.descriptor(), bus.openings()};
      },
      [this, &bus] {
        if (!bus.poll(std::chrono::milliseconds(0))) return false;
        live_->tick();
        return true;
      });
}

}  // namespace markservo::mmi
