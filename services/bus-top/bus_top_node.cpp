#include "services/bus-top/bus_top_node.hpp"

#include <fmt/core.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <stdexcept>

#include "common/bus/end_signals.hpp"
#include "common/bus/options.hpp"
#include "common/bus/tool.hpp"
#include "common/reflection/message_json.hpp"
#include "common/reflection/message_note.hpp"
#include "common/reflection/type_files.hpp"
#include "common/reflection/value_text.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/watch/watch_json.hpp"
#include "services/bus-top/channel_table.hpp"
#include "services/bus-top/field_lines.hpp"
#include "services/bus-top/screen.hpp"

namespace markservo::bus_top {
namespace {

constexpr double kRedraw = 0.25;  // s: what changes faster cannot be read
constexpr int kQueue = 200;       // messages that wait while the screen is drawn

void print(const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stdout);
}

std::vector<std::string> names_of(const watch::BusWatch& watch) {
  std::vector<std::string> names;
  for (const auto& entry : watch.channels()) names.push_back(entry.first);
  return names;
}

// What `make` makes of options; what is wrong with them is told as such.
template <class Make>
auto made_of_options(Make make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw ConfigurationError(error.what());
  }
}

std::string listed(const std::vector<std::string>& names) {
  std::string list;
  for (const std::string& name : names) list += (list.empty() ? "" : ", ") + reflection::printable(name);
  return list.empty() ? "nothing" : list;
}

}  // namespace

void add_options(CLI::App& app, BusTopOptions& options) {
  const bus::Options add(app);
  bus::add_live_bus_option(app, options.url);
  add.option("--robot", options.robot, "Only the channels of this robot, without its prefix");
  add.option(
      "--channel", options.channel,
      "Show the fields of this channel's newest message (its name, or a Perl-compatible regular expression of the "
      "whole name, for one channel)");
  add.option("--types", options.types,
             "Type files of another LCM system (FILE.lcm...), or folders of them, known besides our own types");
  add.flag("--once", options.once, "Print once, as plain text, and end; so without a terminal");
  add.flag("--json", options.json, "Print once, as JSON, and end");
  add.option("--for", options.seconds, "How long to listen before printing once, s").within(0.1, 3600.0).show_default();
  add.footer(
      "Keys: arrows, page up and down, home, end; Enter shows a channel's fields live, Escape goes back; q quits.\n"
      "Hz, bandwidth and writers are of the last 5 s; lost is counted by seq since bus-top listens; stale channels, "
      "older than three of their intervals, are grey, those with losses or undecodable messages bold.\n"
      "Exit codes: 0; 1 nothing was heard, or the message cannot be decoded; 2 bad options or terminal; 3 no bus.");
}

BusTopNode::BusTopNode(BusTopOptions options)
    : options_(std::move(options)),
      prefix_(options_.robot.empty() ? "" : options_.robot + "/"),
      types_(made_of_options([this] { return reflection::types_with(options_.types); })),
      start_(std::chrono::steady_clock::now()),
      listener_(options_.url, ".*", kQueue, [this](const bus::HeardBytes& message) { on_message(message); }) {
  if (options_.channel.empty()) return;
  pattern_ = made_of_options([this] { return ChannelPattern(options_.channel); });
}

double BusTopNode::now() const {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
}

void BusTopNode::on_message(const bus::HeardBytes& message) {
  if (message.channel.compare(0, prefix_.size(), prefix_) != 0) return;
  const auto told = reflection::note_of(types_, message.data, message.size);
  watch_.observe(message.channel.substr(prefix_.size()), told, message.data, now());
}

void BusTopNode::listen(double deadline) {
  while (!bus::told_to_end() && now() < deadline) {
    if (!options_.channel.empty() && watch_.find(options_.channel) != nullptr) return;
    listener_.poll(std::chrono::milliseconds(std::max(1, static_cast<int>(1000.0 * (deadline - now())))));
  }
}

int BusTopNode::print_table() {
  listen(options_.seconds);
  if (options_.json) {
    print(reflection::json_text(watch::watch_json(watch_, options_.seconds, now())));
  } else if (!watch_.channels().empty()) {
    const ChannelTable table = channel_table(watch_, now());
    print(table.heading + "\n");
    for (const ChannelLine& line : table.lines) print(line.text + "\n");
  }
  if (!watch_.channels().empty()) return 0;
  fmt::print(stderr, "bus-top: nothing was heard on {} within {} s{}\n", options_.url, options_.seconds,
             prefix_.empty() ? "" : " on channels that begin with " + prefix_);
  return 1;
}

int BusTopNode::print_channel() {
  listen(options_.seconds);
  const std::vector<std::string> names = watch_.matching(options_.channel, *pattern_);
  if (names.empty()) {
    fmt::print(stderr, "bus-top: no message on {} within {} s; heard: {}\n", reflection::printable(options_.channel),
               options_.seconds, listed(names_of(watch_)));
    return 1;
  }
  if (names.size() > 1) {
    throw ConfigurationError("--channel " + options_.channel + " takes " + listed(names) + "; allowed: one channel");
  }
  const watch::BusWatch::Channel& channel = *watch_.find(names.front());
  const auto message = reflection::decode(types_, channel.newest.data(), channel.newest.size());
  if (!message.error.empty()) {
    fmt::print(stderr, "bus-top: {}: {}\n", reflection::printable(names.front()), message.error);
    return 1;
  }
  if (options_.json) {
    print(reflection::json_text(watch::message_json(names.front(), message.fields)));
  } else {
    for (const std::string& line : field_lines(message.fields)) print(line + "\n");
  }
  return 0;
}

std::vector<std::string> BusTopNode::message_lines(const std::vector<std::uint8_t>& bytes) const {
  const auto message = reflection::decode(types_, bytes.data(), bytes.size());
  if (message.error.empty()) return field_lines(message.fields);
  return {"the newest message cannot be shown: " + message.error};
}

// Once a channel is heard that --channel takes.
void BusTopNode::open_by_pattern(Navigation& navigation) const {
  if (!pattern_ || navigation.opened() != options_.channel) return;
  const std::vector<std::string> names = watch_.matching(options_.channel, *pattern_);
  if (!names.empty() && names.front() != options_.channel) navigation = Navigation(names.front());
}

void BusTopNode::draw(Screen& screen, const Navigation& navigation) const {
  const ChannelTable table = channel_table(watch_, now());
  const std::vector<std::string> names = names_of(watch_);
  std::vector<ScreenLine> body;
  std::string head = table.heading;
  std::string foot = "arrows select, Enter shows the fields, q quits   " + options_.url;
  if (navigation.in_fields()) {
    head = reflection::printable(navigation.opened()) + ": nothing heard yet";
    foot = "arrows scroll, Escape goes back, q quits";
    if (const auto* channel = watch_.find(navigation.opened())) {
      const auto line = std::find(names.begin(), names.end(), navigation.opened());
      head = table.lines[static_cast<std::size_t>(line - names.begin())].text;
      for (std::string& text : message_lines(channel->newest)) body.push_back({std::move(text)});
    }
  } else {
    const int selected = navigation.selected(names);
    for (const ChannelLine& line : table.lines) {
      body.push_back({line.text, line.stale, line.trouble, static_cast<int>(body.size()) == selected});
    }
    if (table.lines.empty()) body.push_back({"nothing heard yet"});
  }
  const int first = navigation.first_line(names, static_cast<int>(body.size()), screen.rows());
  body.erase(body.begin(), body.begin() + first);
  screen.draw(head, body, foot);
}

void BusTopNode::watch_live() {
  Navigation navigation(options_.channel);
  Screen screen;
  double drawn = -kRedraw;
  while (!bus::told_to_end() && !navigation.quit()) {
    bool pressed = false;
    open_by_pattern(navigation);
    do {
      const auto key = screen.read_key();
      if (!key) continue;
      pressed = true;
      const std::vector<std::string> names = names_of(watch_);
      const auto* channel = navigation.in_fields() ? watch_.find(navigation.opened()) : nullptr;
      const std::size_t lines = channel != nullptr ? message_lines(channel->newest).size() : names.size();
      navigation.press(*key, names, static_cast<int>(lines), screen.rows());
    } while (screen.more_keys());
    if (pressed || now() - drawn >= kRedraw) {
      draw(screen, navigation);
      drawn = now();
    }
    pollfd waiting[2]{{listener_.descriptor(), POLLIN, 0}, {STDIN_FILENO, POLLIN, 0}};
    ::poll(waiting, 2, std::max(1, static_cast<int>(1000.0 * (drawn + kRedraw - now()))));
    if ((waiting[1].revents & (POLLHUP | POLLERR)) != 0) return;  // the terminal is gone
    listener_.poll(std::chrono::milliseconds(0));
  }
}

int BusTopNode::run() {
  const bool live = isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0 && !options_.once && !options_.json;
  if (!live) return options_.channel.empty() ? print_table() : print_channel();
  watch_live();
  return 0;
}

}  // namespace markservo::bus_top
