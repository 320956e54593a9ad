#include "services/log-tool/log_tool_options.hpp"

#include "common/bus/bus_url.hpp"
#include "common/bus/named_bus.hpp"
#include "common/bus/options.hpp"

namespace markservo::log_tool {

using Add = bus::Options;

Commands::Commands(bus::CommandLine& command_line, const text::TypedCommand& typed, const Actions& actions)
    : command_line_(&command_line) {
  options_.play.own_name = typed.name_or(options_.play.own_name);
  options_.play.log_command = typed.of("log");
  add_readers(actions);
  add_writers(actions);
  add_joiners(actions);
  add_comparison(actions);
  add_player(actions);
}

Add Commands::command(const char* name, const char* what, Action action) {
  return Add(command_line_->add_command(name, what, [this, action] { action_ = action; }));
}

void Commands::add_choice(const Add& add) {
  // A range also refuses what is no number.
  add.option("--from", options_.choice.from, "s after the log's first event").within(-1e9, 1e9);
  add.option("--to", options_.choice.to, "s after the log's first event, that instant not included").within(-1e9, 1e9);
  add.option("--channel", options_.choice.channels, "These channels only (PATTERN; may be repeated)").one_at_a_time();
  add.option("--without", options_.choice.without, "Not these channels (PATTERN; may be repeated)").one_at_a_time();
}

void Commands::add_types(const Add& add) {
  add.option("--types", options_.types,
             "Type files of another LCM system (FILE.lcm...), or folders of them, known besides our own types");
}

void Commands::add_readers(const Actions& actions) {
  Add add = command("info", "Channels, types, rates, gaps, losses, span, order, damage", actions.info);
  add.option("LOG", options_.inputs).required();
  add.flag("--json", options_.json, "JSON for programs");
  add_types(add);

  add = command("verify", "Says where the log is damaged and what cannot be decoded", actions.verify);
  add.option("LOG", options_.inputs).required();
  add_types(add);

  add = command("types", "The message types that this build knows, with their fingerprints", actions.types);
  add.flag("--json", options_.json, "JSON for programs");
  add_types(add);
}

void Commands::add_writers(const Actions& actions) {
  Add add = command("repair", "Writes all events that can be read to a new log", actions.repair);
  add.option("LOG", options_.input).required();
  add.option("NEW", options_.output).required();
  add_types(add);

  add = command("cut", "Writes a part of the log, by time and channel, to a new log", actions.cut);
  add.option("LOG", options_.input).required();
  add.option("NEW", options_.output).required();
  add_choice(add);

  add = command("export", "Writes CSV per channel and PNG per stereo frame into a folder", actions.export_log);
  add.option("LOG", options_.input).required();
  add.option("FOLDER", options_.output).required();
  add_choice(add);
  add_types(add);

  add = command("extract-config", "Writes the configuration files that a recording kept into a new folder",
                actions.extract_config);
  add.option("RECORDING", options_.input).required();
  add.option("FOLDER", options_.output).required();
}

void Commands::add_joiners(const Actions& actions) {
  Add add = command("merge", "Puts logs together by their events' times, as a new log", actions.merge);
  add.option("LOG LOG... NEW", options_.inputs).required();

  add = command("sort", "Puts a log's events in order of time, as a new log", actions.sort);
  add.option("LOG", options_.input).required();
  add.option("NEW", options_.output).required();

  add = command("splice", "Replaces the channels of DERIVED in RECORDED: what the next service would have heard",
                actions.splice);
  add.option("RECORDED", options_.input).required();
  add.option("DERIVED", options_.other).required();
  add.option("NEW", options_.output).required();
  add.option("--without", options_.choice.without, "Not these channels of RECORDED (PATTERN)").one_at_a_time();
}

void Commands::add_comparison(const Actions& actions) {
  const Add add = command("compare", "Compares what a replay wrote with what was recorded", actions.compare);
  add.option("RECORDED", options_.input).required();
  add.option("REPLAYED", options_.other).required();
  add.option("--tolerance", options_.comparison.tolerance, "Of numbers, absolute and relative, SI units")
      .within(0.0, 1e9)
      .show_default();
  add.flag("--complete", options_.complete, "A message that was not recorded, or recorded only, is a difference too");
  add.flag("--exact", options_.exact, "Demand the same sequence of channels and payloads, byte by byte");
  add_types(add);
}

void Commands::add_player(const Actions& actions) {
  const Add add = command("play", "Plays to a bus what moves no robot", actions.play);
  add.option("LOG", options_.input).required();
  const auto no_live_bus = [](const std::string& url) {
    const bool live = bus::is_udpm(url) || bus::is_tcpq(url);
    if (live) return std::string();
    return url + bus::told_by(url) + ": allowed are udpm:// and tcpq://, a bus that others are on";
  };
  bus::add_lcm_url(add, options_.play.url, "The bus").check(no_live_bus, "udpm:// or tcpq://");
  add.option("--speed", options_.play.speed, "Times the recorded pace").within(1e-6, 1e6).show_default();
  add.option("--channel", options_.play.channels,
             "These channels only (PATTERN), also such as the table of channels does not have; '.*' or '\\w+' names "
             "none of those");
  add.flag("--sort", options_.play.sort, "By the events' times, in place of the log's order");
  add.option("--longest-gap", options_.play.longest_gap,
             "Where nothing was recorded wait so long at most, s of the log")
      .within(0.0, 1e9);
  add.flag("--all", options_.play.all, "Also what moves a robot or speaks for what is there now");
  add.flag("--join", options_.play.join, "Beside others: leaves out what somebody writes and what feeds motion");
}

}  // namespace markservo::log_tool
