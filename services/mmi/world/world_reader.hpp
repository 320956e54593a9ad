#pragma once

// All that has been heard, of the bus or of a log up to a moment, as the page is told of it.

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "common/robot/robot_description.hpp"
#include "common/watch/bus_watch.hpp"
#include "services/mmi/pictures/frame_ring.hpp"
#include "services/mmi/scene/arm_points.hpp"
#include "services/mmi/scene/floor_view.hpp"
#include "services/mmi/scene/message_slots.hpp"
#include "services/mmi/scene/places.hpp"
#include "services/mmi/world/narrator_reader.hpp"

namespace markservo::mmi {

// A text in JSON, made anew when what it is made of has changed.
struct VersionedText {
  std::uint64_t version = 0;
  std::string text = "null";
};

class WorldReader {
 public:
  struct Parameters {
    NarratorReader::Parameters narrator;
    double figures_every = 1.0;  // s
  };

  // `robot` must be valid; `tag_field`: a name, or empty for the field in use. Throws ConfigurationError.
  WorldReader(const robot::RobotDescription& robot, const std::string& tag_field)
      : WorldReader(robot, tag_field, Parameters{}) {}
  WorldReader(const robot::RobotDescription& robot, const std::string& tag_field, const Parameters& parameters);

  // Takes a message in: any bytes on any `channel`, without a robot's prefix. `at`: us, arrival; `now`: s of a clock
  // that does not go back.
  void observe(const std::string& channel, const void* data, std::size_t size, std::int64_t at, double now);
  // Time passes, whether or not something is heard; `at` (us) is what the source's clock shows.
  void advance(std::int64_t at, double now);

  const MessageSlots& slots() const { return slots_; }
  const EventLog& events() const { return narrator_.events(); }
  const RobotState& state() const { return narrator_.state(); }
  std::int64_t untold() const { return narrator_.untold(); }
  const std::vector<Trouble>& troubles() const { return narrator_.troubles(); }
  const FrameRing& frames() const { return frames_; }
  const watch::BusWatch& watch() const { return watch_; }
  double now() const { return now_; }  // s, the latest that was told
  // s since it began to listen.
  double heard_for() const { return began_ ? now_ - *began_ : 0.0; }

  const VersionedText& arm();
  const VersionedText& places();
  const VersionedText& floor();
  const VersionedText& trouble_list();
  // {"CHANNEL": {...}, ...}, anew once a second: what BusWatch knows, and what was `refused`, how often and why last.
  const VersionedText& figures() const { return figures_; }
  // {"MARK_DETECTION": s, ...}, likewise.
  const VersionedText& latency() const { return latency_; }

 private:
  void join_frame(const std::string& channel, const Bytes& bytes, std::int64_t at, double now);
  void refuse(const std::string& channel, const std::string& why);
  void make_figures();

  Parameters parameters_;
  MessageSlots slots_;
  FrameRing frames_;
  watch::BusWatch watch_{watch::BusWatch::Keeps::kFigures};
  ArmView arm_view_;
  Places places_view_;
  FloorView floor_view_;
  NarratorReader narrator_;

  // Messages that are of no use, by channel.
  struct Refused {
    std::int64_t count = 0;
    std::string why;  // of the newest
  };
  std::map<std::string, Refused> refused_;

  double now_ = 0.0;
  std::optional<double> began_;
  std::optional<double> figures_made_;
  VersionedText arm_;
  VersionedText places_;
  VersionedText floor_;
  VersionedText trouble_list_;
  VersionedText figures_;
  VersionedText latency_;
};

}  // namespace markservo::mmi
