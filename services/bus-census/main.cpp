// bus-census: listens for a moment and tells who is on the bus and what each writes.
//   in: all channels     out: standard output

#include <cstdint>
#include <iostream>

#include "common/bus/clock_tolerance.hpp"
#include "common/bus/end_signals.hpp"
#include "common/bus/host_name.hpp"
#include "common/bus/network_check.hpp"
#include "common/bus/options.hpp"
#include "common/bus/service.hpp"
#include "common/bus/tool.hpp"
#include "common/census/census_text.hpp"
#include "common/reflection/message_json.hpp"
#include "common/robot/configuration_error.hpp"
#include "common/time/clocks.hpp"
#include "services/bus-census/bus_census_node.hpp"
#include "services/bus-census/clock_reader.hpp"
#include "services/bus-census/room.hpp"

namespace {

namespace census = markservo::census;
using markservo::bus_census::BusCensusNode;
using markservo::bus_census::needs_room;
using markservo::bus_census::RoomWish;
using Json = nlohmann::ordered_json;

struct Options {
  std::string url = markservo::bus::kDefaultUrl;
  double seconds = 1.5;  // every service speaks once a second
  bool json = false;
  bool follow = false;
  bool defaults = false;
  RoomWish room;
  std::vector<int> own;
  std::vector<std::string> own_sessions;  // as JSON has them
};

void print(const Json& json) {
  std::cout << markservo::reflection::json_text(json, -1) << std::flush;
}

Json receive_buffer() {
  constexpr std::int64_t kAsked = 4'194'304;  // bytes, as the default URL does
  const auto granted = markservo::bus::granted_receive_buffer(kAsked);
  return {{"asked", kAsked},
          {"granted", granted ? Json(*granted) : Json()},
          {"raw_frames_need", markservo::bus::kReceiveBufferForRawFrames}};
}

// Says what stands against it; exits 0 where nothing does. A process of one's own may be late with its word.
int tell_room(const Options& options, BusCensusNode* node) {
  constexpr double kStep = 0.2;      // s
  constexpr double kPatience = 5.0;  // s; one that is silent for longer hangs
  RoomWish wish = options.room;
  wish.host = markservo::bus::host_name();
  wish.own.insert(options.own.begin(), options.own.end());
  for (double waited = 0.0; waited < kPatience && !wish.own.empty(); waited += kStep) {
    if (markservo::bus::told_to_end() || !somebody_is_unknown(node->report(), wish)) break;
    node->listen_on(kStep);
  }
  const std::vector<std::string> lines = obstacles(node->report(), wish);
  for (const std::string& line : lines) std::cout << line << "\n";
  return lines.empty() ? markservo::bus::kExitStopped : markservo::bus::kExitFailed;
}

// As a script reads it.
void print_defaults() {
  std::cout << "url=" << markservo::bus::kDefaultUrl << "\n"
            << "raw-frames-need=" << markservo::bus::kReceiveBufferForRawFrames << "\n"
            << "clock-tolerance-s=" << 1e-6 * static_cast<double>(markservo::bus::kClockTolerance_us) << "\n";
}

// Throws ConfigurationError.
void read_sessions(Options& options) {
  for (const std::string& text : options.own_sessions) {
    const auto session = census::session_of(text);
    if (!session) {
      throw markservo::ConfigurationError("--own-sessions '" + text + "'; allowed: 0x and 1 to 16 hexadecimal digits");
    }
    options.room.own_sessions.insert(*session);
  }
}

int run(Options& options) {
  read_sessions(options);
  if (options.defaults) {
    print_defaults();
    return markservo::bus::kExitStopped;
  }
  if (!options.room.services.empty() && !needs_room(options.room.services)) return markservo::bus::kExitStopped;
  BusCensusNode node(options.url, options.follow);
  if (options.follow) {
    node.on_status = [](const census::ServiceWord& word) { print(census::json_of(word)); };
    print({{"listening", options.url}});
  }
  const std::int64_t wall_us = markservo::wall_clock_us();
  const std::int64_t steady_us = markservo::steady_clock_us();
  node.listen(options.seconds);
  const std::int64_t jump_us = (markservo::wall_clock_us() - wall_us) - (markservo::steady_clock_us() - steady_us);
  if (options.follow) return markservo::bus::kExitStopped;
  if (!options.room.services.empty()) return tell_room(options, &node);
  if (!options.json) {
    std::cout << census::table_of(node.report());
    return markservo::bus::kExitStopped;
  }
  Json json = {{"url", options.url},
               {"host", markservo::bus::host_name()},
               {"version", MARKSERVO_VERSION},
               {"raw_frames_fit", markservo::bus::raw_frames_fit(options.url)},
               {"receive_buffer", receive_buffer()},
               {"clock",
                {{"synchronised", markservo::bus_census::clock_is_synchronised()},
                 {"jump_s", 1e-6 * static_cast<double>(jump_us)}}}};
  json.update(census::json_of(node.report()));
  print(json);
  return markservo::bus::kExitStopped;
}

void add_options(CLI::App& app, Options& options) {
  markservo::bus::add_live_bus_option(app, options.url);
  const markservo::bus::Options add(app);
  add.option("--for", options.seconds, "Listen so long, s").within(0.1, 3600.0).show_default();
  const auto json = add.flag("--json", options.json, "One JSON object instead of tables");
  add.flag("--follow", options.follow, "Print each SERVICE_STATUS instead when it comes, one JSON object a line")
      .excludes(json);
  add.flag("--defaults", options.defaults,
           "Instead: print what holds where nobody says otherwise: the bus, the receive buffer that raw frames need "
           "(bytes), how far ahead a clock may be (s)");
  add.option("--room-for", options.room.services,
             "Instead: name who writes already what these services would write; exits 1 if somebody does")
      .delimiter(',');
  add.option("--robot", options.room.robot, "With --room-for: this robot's channels only, '' for no prefix");
  add.option("--own", options.own, "With --room-for: processes of this host that are no obstacle").delimiter(',');
  add.option("--own-sessions", options.own_sessions,
             "With --own: the sessions that they are known to write by, as --json shows them")
      .delimiter(',');
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  return markservo::bus::run_tool(
      {"bus-census", "Listens for a moment and tells who is on the bus: services (SERVICE_STATUS) and channels"}, argc,
      argv, [&options](CLI::App& app) { add_options(app, options); }, [&options] { return run(options); });
}
