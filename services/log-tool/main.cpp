// Looks into LCM logs, mends them, cuts them, compares them, plays them.
//   in: log files     out: log files, CSV, PNG, text or JSON; `play` writes to a bus

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/bus/bus_unavailable.hpp"
#include "common/bus/bus_url.hpp"
#include "common/bus/command_line.hpp"
#include "common/bus/exit_code.hpp"
#include "common/bus/options.hpp"
#include "common/reflection/type_catalog.hpp"
#include "common/reflection/value_text.hpp"
#include "common/text/typed_command.hpp"
#include "services/log-tool/comparison_report.hpp"
#include "services/log-tool/event_choice.hpp"
#include "services/log-tool/export_command.hpp"
#include "services/log-tool/extract_config_command.hpp"
#include "services/log-tool/info_report.hpp"
#include "services/log-tool/log_files.hpp"
#include "services/log-tool/log_splice.hpp"
#include "services/log-tool/play_node.hpp"

namespace {

using namespace markservo::log_tool;
using Add = markservo::bus::Options;
using markservo::reflection::json_text;
using markservo::reflection::TypeCatalog;

constexpr int kGood = 0;
constexpr int kDamagedOrDifferent = 1;
constexpr int kBusInUse = 1;
constexpr int kBadInput = 2;
constexpr int kNoBus = markservo::bus::kExitBusUnavailable;

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

struct Options {
  std::vector<std::string> inputs;
  std::string input;
  std::string other;
  std::string output;
  bool json = false;
  bool exact = false;
  bool complete = false;
  EventChoice choice;
  ComparisonParameters comparison;
  PlayOptions play;
};

LogSet open_logs(const std::vector<std::string>& paths) {
  return LogSet(paths, fit_of_our_types);
}

int info(const Options& options) {
  const LogSet logs = open_logs(options.inputs);
  const LogSummary summary = summarise(logs.events(), TypeCatalog::ours());
  if (options.json) {
    print(json_text(info_json(logs, summary)));
  } else {
    print(info_text(logs, summary));
    print(damage_text(logs, summary));
  }
  return logs.damaged() ? kDamagedOrDifferent : kGood;
}

int verify(const Options& options) {
  const LogSet logs = open_logs(options.inputs);
  const LogSummary summary = summarise(logs.events(), TypeCatalog::ours());
  const std::string damage = damage_text(logs, summary);
  print(damage);
  print(std::to_string(summary.events) + " events" + (damage.empty() ? ", no damage\n" : " can be read\n"));
  return damage.empty() ? kGood : kDamagedOrDifferent;
}

int repair(const Options& options) {
  const LogSet logs = open_logs({options.input});
  const std::vector<Event> events = logs.events();
  write_log(options.output, events);
  std::size_t lost = 0;
  for (const auto& file : logs.files()) {
    for (const Damage& damage : file->damage()) lost += damage.bytes;
  }
  print(options.output + ": " + std::to_string(events.size()) + " events; " + std::to_string(lost) +
        " damaged bytes left out\n");
  return kGood;
}

int cut(const Options& options) {
  const LogSet logs = open_logs({options.input});
  const std::vector<Event> events = chosen(logs.events(), options.choice);
  if (events.empty()) throw LogFileError(options.input + ": no event is chosen; allowed: times and channels it has");
  write_log(options.output, events);
  print(options.output + ": " + std::to_string(events.size()) + " events\n");
  return kGood;
}

int export_log(const Options& options) {
  const LogSet logs = open_logs({options.input});
  print(export_events(chosen(logs.events(), options.choice), options.output));
  return kGood;
}

int extract(const Options& options) {
  print(extract_config(options.input, options.output));
  return kGood;
}

int compare_logs(const Options& options) {
  const LogSet recorded = open_logs({options.input});
  const LogSet replayed = open_logs({options.other});
  const std::vector<Event> before = recorded.events();
  const std::vector<Event> now = replayed.events();
  if (options.exact) {
    const std::string mismatch = first_mismatch(before, now);
    print(mismatch.empty() ? "the same " + std::to_string(now.size()) + " events\n" : mismatch + "\n");
    return mismatch.empty() ? kGood : kDamagedOrDifferent;
  }
  const LogComparison comparison = compare(before, now, TypeCatalog::ours(), options.comparison);
  print(comparison_text(comparison, options.comparison));
  const bool same = options.complete ? comparison.complete() : comparison.as_recorded();
  return same ? kGood : kDamagedOrDifferent;
}

int splice(const Options& options) {
  const LogSet recorded = open_logs({options.input});
  const LogSet derived = open_logs({options.other});
  write_log(options.output, spliced(chosen(recorded.events(), options.choice), derived.events()));
  return kGood;
}

int play_log(const Options& options) {
  return play(open_logs({options.input}), options.play) ? kGood : kDamagedOrDifferent;
}

int types(const Options& options) {
  nlohmann::ordered_json json;
  for (const auto* type : TypeCatalog::ours().all()) {
    const std::string fingerprint = markservo::reflection::fingerprint_text(type->fingerprint);
    if (options.json) {
      json[type->name] = fingerprint;
    } else {
      print(fingerprint + " " + type->name + "\n");
    }
  }
  if (options.json) print(json_text(json));
  return kGood;
}

class Commands {
 public:
  Commands(markservo::bus::CommandLine& command_line, const markservo::text::TypedCommand& typed)
      : command_line_(&command_line) {
    options_.play.own_name = typed.name_or(options_.play.own_name);
    options_.play.log_command = typed.of("log");
  }

  void add_all() {
    add_readers();
    add_writers();
    add_comparison();
    add_player();
  }

  // The one that was chosen.
  int run() const { return action_(options_); }

 private:
  using Action = int (*)(const Options&);

  Add command(const char* name, const char* what, Action action) {
    return Add(command_line_->add_command(name, what, [this, action] { action_ = action; }));
  }

  void add_choice(const Add& add) {
    // A range also refuses what is no number.
    add.option("--from", options_.choice.from, "s after the log's first event").within(-1e9, 1e9);
    add.option("--to", options_.choice.to, "s after the log's first event, that instant not included")
        .within(-1e9, 1e9);
    add.option("--channel", options_.choice.channels, "These channels only (regular expression; may be repeated)")
        .one_at_a_time();
    add.option("--without", options_.choice.without, "Not these channels").one_at_a_time();
  }

  void add_readers() {
    Add add = command("info", "Channels, types, rates, gaps, losses, span, damage", info);
    add.option("LOG", options_.inputs).required();
    add.flag("--json", options_.json, "JSON for programs");

    add = command("verify", "Says where the log is damaged and what cannot be decoded", verify);
    add.option("LOG", options_.inputs).required();

    add = command("types", "The message types that this build knows, with their fingerprints", types);
    add.flag("--json", options_.json, "JSON for programs");
  }

  void add_writers() {
    Add add = command("repair", "Writes all events that can be read to a new log", repair);
    add.option("LOG", options_.input).required();
    add.option("NEW", options_.output).required();

    add = command("cut", "Writes a part of the log, by time and channel, to a new log", cut);
    add.option("LOG", options_.input).required();
    add.option("NEW", options_.output).required();
    add_choice(add);

    add = command("splice", "Replaces the channels of DERIVED in RECORDED: what the next service would have heard",
                  splice);
    add.option("RECORDED", options_.input).required();
    add.option("DERIVED", options_.other).required();
    add.option("NEW", options_.output).required();
    add.option("--without", options_.choice.without, "Not these channels of RECORDED").one_at_a_time();

    add = command("export", "Writes CSV per channel and PNG per stereo frame into a folder", export_log);
    add.option("LOG", options_.input).required();
    add.option("FOLDER", options_.output).required();
    add_choice(add);

    add = command("extract-config", "Writes the configuration files that a recording kept into a new folder", extract);
    add.option("RECORDING", options_.input).required();
    add.option("FOLDER", options_.output).required();
  }

  void add_comparison() {
    const Add add = command("compare", "Compares what a replay wrote with what was recorded", compare_logs);
    add.option("RECORDED", options_.input).required();
    add.option("REPLAYED", options_.other).required();
    add.option("--tolerance", options_.comparison.tolerance, "Of numbers, absolute and relative, SI units")
        .within(0.0, 1e9)
        .show_default();
    add.flag("--complete", options_.complete, "A message that was not recorded, or recorded only, is a difference too");
    add.flag("--exact", options_.exact, "Demand the same sequence of channels and payloads, byte by byte");
  }

  void add_player() {
    const Add add = command("play", "Plays to a bus what moves no robot", play_log);
    add.option("LOG", options_.input).required();
    const auto no_live_bus = [](const std::string& url) {
      const bool live = markservo::bus::is_udpm(url) || url.rfind("tcpq://", 0) == 0;
      return live ? std::string() : url + ": allowed are udpm:// and tcpq://, a bus that others are on";
    };
    add.option("--lcm-url", options_.play.url, "The bus")
        .environment("MARKSERVO_LCM_URL")
        .check(no_live_bus, "udpm:// or tcpq://")
        .show_default();
    add.option("--speed", options_.play.speed, "Times the recorded pace").within(1e-6, 1e6).show_default();
    add.option("--channel", options_.play.channels,
               "These channels only (regular expression), also such as the table of channels does not have");
    add.flag("--all", options_.play.all, "Also what moves a robot or speaks for what is there now");
    add.flag("--join", options_.play.join, "Beside others: leaves out what somebody writes and what feeds motion");
  }

  markservo::bus::CommandLine* command_line_;
  Options options_;
  Action action_ = nullptr;
};

}  // namespace

int main(int argc, char** argv) {
  markservo::bus::CommandLine command_line(
      "log-tool",
      "Looks into LCM logs, mends, cuts, exports, compares and plays them. A LOG is a file or a recording's folder.\n"
      "Exits 0 when all is well, 1 for a damaged log, a difference or a bus in use, 2 for what is no log or a wrong\n"
      "option, 3 for a bus that cannot be joined.");
  const markservo::text::TypedCommand typed(argc > 0 ? argv[0] : "");
  Commands commands(command_line, typed);
  commands.add_all();
  if (const auto exit_code = command_line.parse(argc, argv)) return *exit_code;
  try {
    return commands.run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s\n", typed.name_or("log-tool").c_str(), error.what());
    if (dynamic_cast<const markservo::bus::BusUnavailable*>(&error) != nullptr) return kNoBus;
    return dynamic_cast<const BusInUse*>(&error) != nullptr ? kBusInUse : kBadInput;
  }
}
