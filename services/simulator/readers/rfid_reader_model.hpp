#pragma once

// An RFID reader under the base: inventory rounds back to back, in which every tag in reach answers or not at a moment
// of its own; the host hears of a round some time later. Noise is in who answers and when, never on a position.

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <vector>

#include "common/geometry/plane_pose.hpp"
#include "common/robot/robot_description.hpp"
#include "services/simulator/readers/tag_floor.hpp"

namespace markservo::simulator {

struct RfidReaderParameters {
  std::optional<double> delay;  // s, from a round's middle to its arrival, half a round or more; else the description's
  double delay_jitter = 0.0;    // s, an answer comes up to this much earlier or later; never before its round's end
  double missed = 0.0;          // share of reads that fail besides, [0, 1]
  double duplicates = 0.0;      // share of reads that are told twice, [0, 1]
  double unknown_tags = 0.0;    // per round, the chance of reading a tag that is not in the map, [0, 1]
  double false_reads = 0.0;     // per round, the chance of reading a tag of the map that is far away, [0, 1]
  bool read_time_known = false;  // the reader's clock is tied to the host's: true windows and times of reads

  // How strong an answer is: log-distance model with plausible values for a coil 5 cm above the floor.
  double rssi_near = -45.0;      // dBm, straight below
  double antenna_height = 0.05;  // m
  double path_loss_exponent = 3.0;
  double rssi_noise = 2.0;  // dB
};

struct TagHit {
  std::string uid;
  std::int64_t utime = 0;       // us, when the host heard of it
  std::int64_t read_utime = 0;  // us, when it was read; 0 unless read_time_known
  bool read_time_known = false;
  double rssi = 0.0;  // dBm
};

// What the host hears of a round; as RfidTagHits.lcm has it.
struct TagRound {
  std::int64_t utime = 0;         // us, arrival
  std::int64_t window_start = 0;  // us
  std::int64_t window_end = 0;    // us
  bool window_known = false;
  std::vector<TagHit> hits;  // in the order they were read
};

class RfidReaderModel {
 public:
  // Throws std::invalid_argument for parameters out of range.
  RfidReaderModel(const robot::RfidDescription& reader, const RfidReaderParameters& parameters, TagFloor floor,
                  std::uint64_t seed);

  // From now on the reader reads like this; rounds under way keep what was read. Throws as the constructor, and changes
  // nothing.
  void change(const RfidReaderParameters& parameters);

  // The robot is at X_WR at `utime` (us), having come there evenly since the last call; the first call begins the first
  // round. How far apart the calls are does not matter otherwise. Throws std::invalid_argument if time does not
  // advance.
  void observe(std::int64_t utime, const geometry::PlanePose& X_WR);

  // The rounds that have arrived by `utime` (us), oldest first, each once.
  std::vector<TagRound> take_arrived(std::int64_t utime);

  const TagFloor& floor() const { return floor_; }

 private:
  struct Antenna {
    std::int64_t utime;
    Eigen::Vector2d p_W;
  };
  struct Read {
    std::int64_t utime;
    std::string uid;
    double rssi;
  };

  double read_probability(double distance) const;
  double rssi(double distance, double noise) const;
  void read_between(const Antenna& from, const Antenna& to, std::int64_t begin, std::int64_t end);
  void add_strays(const Eigen::Vector2d& p_WF);
  void finish_round(const Eigen::Vector2d& p_WF);
  std::int64_t round_end() const { return round_start_ + round_us_; }

  robot::RfidDescription reader_;
  RfidReaderParameters parameters_;
  TagFloor floor_;
  std::uint64_t seed_;
  std::int64_t round_us_;
  std::optional<Antenna> last_;
  std::uint64_t round_ = 0;  // number of the one under way
  std::int64_t round_start_ = 0;
  std::vector<Read> reads_;        // of the round under way
  std::int64_t last_arrival_ = 0;  // 0: none yet
  std::deque<TagRound> under_way_;
};

}  // namespace markservo::simulator
