#pragma once

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "common/bus/bus_url.hpp"
#include "common/bus/listener.hpp"
#include "common/channel_pattern/channel_pattern.hpp"
#include "common/reflection/type_catalog.hpp"
#include "common/watch/bus_watch.hpp"
#include "services/bus-top/navigation.hpp"

namespace CLI {
class App;
}

namespace markservo::bus_top {

class Screen;

struct BusTopOptions {
  std::string url = bus::kDefaultUrl;
  std::string robot;               // only its channels, without its prefix
  std::string channel;             // ChannelPattern: only this one's fields
  std::vector<std::string> types;  // files and folders of another system's
  bool once = false;
  bool json = false;
  double seconds = 2.0;  // s, how long --once listens: two messages of a 1 Hz channel
};

void add_options(CLI::App& app, BusTopOptions& options);

// Listens to all channels and shows them; writes nothing to the bus.
class BusTopNode {
 public:
  // Throws bus::BusUnavailable, and ConfigurationError for types or a channel that cannot be.
  explicit BusTopNode(BusTopOptions options);
  BusTopNode(const BusTopNode&) = delete;
  BusTopNode& operator=(const BusTopNode&) = delete;

  // Returns the exit code: 0; 1 when --once heard nothing, or nothing that decodes on --channel. Throws
  // ConfigurationError where --channel takes several channels or the terminal cannot be drawn on, bus::BusUnavailable.
  int run();

 private:
  void on_message(const bus::HeardBytes& message);
  double now() const;
  // Until `deadline` (as now() tells it), a signal, or one message on the channel that --channel names.
  void listen(double deadline);
  int print_table();
  int print_channel();
  void watch_live();
  void draw(Screen& screen, const Navigation& navigation) const;
  void open_by_pattern(Navigation& navigation) const;
  std::vector<std::string> message_lines(const std::vector<std::uint8_t>& bytes) const;

  BusTopOptions options_;
  std::string prefix_;  // of the robot's channels
  reflection::TypeCatalog types_;
  std::optional<ChannelPattern> pattern_;  // of --channel
  std::chrono::steady_clock::time_point start_;
  watch::BusWatch watch_;
  bus::Listener listener_;
};

}  // namespace markservo::bus_top
