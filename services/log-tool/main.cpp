// Looks into LCM logs, mends them, cuts them, puts them together, compares them, plays them.
//   in: log files     out: log files, CSV, PNG, text or JSON; `play` writes to a bus

#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "common/bus/bus_unavailable.hpp"
#include "common/bus/command_line.hpp"
#include "common/bus/exit_code.hpp"
#include "common/bus/named_bus.hpp"
#include "common/logs/log_files.hpp"
#include "common/reflection/message_json.hpp"
#include "common/reflection/type_files.hpp"
#include "common/text/typed_command.hpp"
#include "services/log-tool/comparison_report.hpp"
#include "services/log-tool/export_command.hpp"
#include "services/log-tool/extract_config_command.hpp"
#include "services/log-tool/info_report.hpp"
#include "services/log-tool/log_merge.hpp"
#include "services/log-tool/log_splice.hpp"
#include "services/log-tool/log_tool_options.hpp"
#include "services/log-tool/play_node.hpp"

namespace {

namespace logs = markservo::logs;
using namespace markservo::log_tool;
using markservo::reflection::json_text;
using markservo::reflection::shown_name;
using markservo::reflection::TypeCatalog;
using markservo::reflection::types_with;

constexpr int kGood = 0;
constexpr int kDamagedOrDifferent = 1;
constexpr int kBusInUse = 1;
constexpr int kBadInput = 2;
constexpr int kNoBus = markservo::bus::kExitBusUnavailable;

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

logs::LogSet open_logs(const std::vector<std::string>& paths, const TypeCatalog& types = TypeCatalog::ours()) {
  return logs::LogSet(paths, logs::fit_of(types));
}

int info(const Options& options) {
  const TypeCatalog known = types_with(options.types);
  const logs::LogSet logs = open_logs(options.inputs, known);
  const LogSummary summary = summarise(logs.events(), known);
  if (options.json) {
    print(json_text(info_json(logs, summary)));
  } else {
    print(info_text(logs, summary));
    print(damage_text(logs, summary));
  }
  return logs.damaged() ? kDamagedOrDifferent : kGood;
}

int verify(const Options& options) {
  const TypeCatalog known = types_with(options.types);
  const logs::LogSet logs = open_logs(options.inputs, known);
  const LogSummary summary = summarise(logs.events(), known);
  const std::string damage = damage_text(logs, summary);
  print(damage);
  print(std::to_string(summary.events) + " events" + (damage.empty() ? ", no damage\n" : " can be read\n"));
  return damage.empty() ? kGood : kDamagedOrDifferent;
}

int repair(const Options& options) {
  const TypeCatalog known = types_with(options.types);
  const logs::LogSet logs = open_logs({options.input}, known);
  const std::vector<logs::LogEvent> events = logs.events();
  logs::write_log(options.output, events);
  std::size_t lost = 0;
  for (const auto& file : logs.files()) {
    for (const logs::Damage& damage : file->damage()) lost += damage.bytes;
  }
  print(options.output + ": " + std::to_string(events.size()) + " events; " + std::to_string(lost) +
        " damaged bytes left out\n");
  return kGood;
}

int cut(const Options& options) {
  const logs::LogSet logs = open_logs({options.input});
  const std::vector<logs::LogEvent> events = chosen(logs.events(), options.choice);
  if (events.empty())
    throw logs::LogFileError(options.input + ": no event is chosen; allowed: times and channels it has");
  logs::write_log(options.output, events);
  print(options.output + ": " + std::to_string(events.size()) + " events\n");
  return kGood;
}

// What is put together: each input's events refer to its log.
int write_merged(const std::vector<std::string>& paths, const std::string& output) {
  std::vector<logs::LogSet> logs;
  std::vector<MergeInput> inputs;
  for (const std::string& path : paths) {
    logs.push_back(open_logs({path}));
    inputs.push_back({path, logs.back().events()});
    if (logs.back().damaged()) print(path + ": is damaged: what can be read is taken (verify says more)\n");
  }
  const Merge merge = merged(inputs);
  logs::write_log(output, merge.events);
  for (const std::string& remark : merge.remarks) print(remark + "\n");
  print(output + ": " + std::to_string(merge.events.size()) + " events by time; " + std::to_string(merge.late) +
        " were out of order\n");
  return kGood;
}

int merge_logs(const Options& options) {
  constexpr std::size_t kFewest = 3;
  if (options.inputs.size() < kFewest)
    throw logs::LogFileError("merge: allowed are two logs or more, and then the new one");
  return write_merged({options.inputs.begin(), options.inputs.end() - 1}, options.inputs.back());
}

int sort_log(const Options& options) {
  return write_merged({options.input}, options.output);
}

int export_log(const Options& options) {
  const TypeCatalog known = types_with(options.types);
  const logs::LogSet logs = open_logs({options.input}, known);
  print(export_events(chosen(logs.events(), options.choice), options.output, known));
  return kGood;
}

int extract(const Options& options) {
  print(extract_config(options.input, options.output));
  return kGood;
}

int compare_logs(const Options& options) {
  const TypeCatalog known = types_with(options.types);
  const logs::LogSet recorded = open_logs({options.input}, known);
  const logs::LogSet replayed = open_logs({options.other}, known);
  const std::vector<logs::LogEvent> before = recorded.events();
  const std::vector<logs::LogEvent> now = replayed.events();
  if (options.exact) {
    const std::string mismatch = first_mismatch(before, now);
    print(mismatch.empty() ? "the same " + std::to_string(now.size()) + " events\n" : mismatch + "\n");
    return mismatch.empty() ? kGood : kDamagedOrDifferent;
  }
  const LogComparison comparison = compare(before, now, known, options.comparison);
  print(comparison_text(comparison, options.comparison));
  const bool same = options.complete ? comparison.complete() : comparison.as_recorded();
  return same ? kGood : kDamagedOrDifferent;
}

int splice(const Options& options) {
  const logs::LogSet recorded = open_logs({options.input});
  const logs::LogSet derived = open_logs({options.other});
  logs::write_log(options.output, spliced(chosen(recorded.events(), options.choice), derived.events()));
  return kGood;
}

int play_log(const Options& options) {
  return play(open_logs({options.input}), options.play) ? kGood : kDamagedOrDifferent;
}

int types(const Options& options) {
  nlohmann::ordered_json json;
  const TypeCatalog known = types_with(options.types);
  for (const auto* type : known.all()) {
    const std::string fingerprint = markservo::reflection::fingerprint_text(type->fingerprint);
    if (options.json) {
      json[shown_name(*type)] = fingerprint;
    } else {
      print(fingerprint + " " + shown_name(*type) + "\n");
    }
  }
  if (options.json) print(json_text(json));
  return kGood;
}

}  // namespace

int main(int argc, char** argv) {
  markservo::bus::CommandLine command_line(
      "log-tool",
      "Looks into LCM logs, mends, cuts, merges, exports, compares and plays them. A LOG is a file or a recording's\n"
      "folder. A PATTERN is a channel's name, or a Perl-compatible regular expression of the whole name.\n"
      "Exits 0 when all is well, 1 for a damaged log, a difference or a bus in use, 2 for what is no log or a wrong\n"
      "option, 3 for a bus that cannot be joined.");
  const markservo::text::TypedCommand typed(argc > 0 ? argv[0] : "");
  Commands commands(
      command_line, typed,
      {info, verify, types, repair, cut, merge_logs, sort_log, splice, export_log, extract, compare_logs, play_log});
  if (const auto exit_code = command_line.parse(argc, argv)) return *exit_code;
  try {
    return commands.run();
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s: %s%s\n", typed.name_or("log-tool").c_str(), error.what(),
                 markservo::bus::told_by(error.what()).c_str());
    if (dynamic_cast<const markservo::bus::BusUnavailable*>(&error) != nullptr) return kNoBus;
    return dynamic_cast<const BusInUse*>(&error) != nullptr ? kBusInUse : kBadInput;
  }
}
