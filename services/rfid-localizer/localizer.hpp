#pragma once

// Where the robot is, by the floor's tags: an assumed density filter. Each round of the reader is matched where the
// antenna was in its middle, a delay before its answer came; from there the wheels, or inertia, lead to now. No clock:
// every time is a message's. The same inputs in the same order give the same estimates.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/rfid-localizer/belief.hpp"
#include "services/rfid-localizer/encoder_counters.hpp"
#include "services/rfid-localizer/input_times.hpp"
#include "services/rfid-localizer/motion_choice.hpp"
#include "services/rfid-localizer/paper_method.hpp"
#include "services/rfid-localizer/round_update.hpp"
#include "services/rfid-localizer/trust.hpp"

namespace markservo::rfid_localizer {

struct TagRead {
  std::string uid;
  std::optional<std::int64_t> read_utime;  // us, on the host's clock, when the reader tells it
};

struct TagRound {
  std::int64_t utime = 0;         // us, of the answer's arrival
  std::int64_t session = 0;       // of the reader's driver
  std::int64_t window_start = 0;  // us; as RfidTagHits.lcm says
  std::int64_t window_end = 0;
  bool window_known = false;
  std::vector<TagRead> reads;
};

struct LocalizerParameters {
  DelayPrior delay{0.19, 0.005};
  double survey_sigma = 0.0;  // m, each axis, of the tags' positions in the map
  std::optional<HeadingPrior> start_heading;
  WheelMotionParameters wheels;
  std::optional<WheelJudgeParameters> judge = WheelJudgeParameters{};  // nothing: wheels are as stated
  FreeMotionParameters free;
  RoundMatchParameters match;
  TagReliabilityParameters reliability;
  TrustParameters trust;
  PaperParameters paper;
  double wheels_missing = 0.5;  // s without encoders, after which inertia has to do
  double hopeless_sigma = 1.0;  // m, of the position: to begin anew at the next tag says more
};

// What was wrong with the inputs, counted since the start.
struct LocalizerFaults {
  std::int64_t unknown_tags = 0;    // reads of uids that the map does not have
  std::int64_t far_tags = 0;        // reads of tags that the antenna cannot have reached
  std::int64_t repeated_reads = 0;  // of one tag in one round
  std::int64_t late_rounds = 0;     // at or before the time of the last one
  std::int64_t late_odometry = 0;   // likewise
  std::int64_t wrong_windows = 0;   // rounds said to have been when they cannot have been
  std::int64_t tick_jumps = 0;      // of the encoders' counters
};

struct Estimate {
  Placement placement = Placement::kSearching;
  std::string reason;  // why not localised
  PoseEstimate pose;
  bool odometry_used = false;
  DelayPrior delay;
  std::optional<PaperEstimate> paper;  // of the newest round that read a tag
};

class Localizer {
 public:
  // Throws std::invalid_argument if the field is empty or a parameter impossible.
  Localizer(const robot::BaseDescription& base, const robot::RfidDescription& rfid, const robot::TagField& field,
            const LocalizerParameters& parameters);

  // Throw std::invalid_argument, change nothing but the count of faults, when time does not go on or a round's known
  // window is impossible.
  void observe(const EncoderReading& reading);
  void observe(const TagRound& round);

  // At `utime` (us), that of the newest input.
  Estimate estimate(std::int64_t utime) const;

  bool has_wheels() const { return motion_.by_wheels(); }
  LocalizerFaults faults() const;
  WheelJudgement wheel_judgement() const { return motion_.judgement(); }
  const TagReliability& reliability() const { return floor_.reliability; }

 private:
  // Throw std::invalid_argument and count a fault where the round cannot be.
  void check_window(const TagRound& round);
  void follow_time(const TagRound& round);

  RoundTime time_of(const TagRound& round) const;
  std::vector<HeardTag> heard_in(const TagRound& round);
  // Those that the antenna can have reached; the others are faults.
  std::vector<HeardTag> reachable(const std::vector<HeardTag>& heard);
  void choose_motion(std::int64_t utime);
  void begin(const std::vector<HeardTag>& heard, std::int64_t utime);
  // True if the round ends all trust in the estimate.
  bool match(const std::vector<HeardTag>& heard, const RoundTime& time);
  // Gives up what is believed of the place.
  void lose(const std::string& why);
  // Likewise, and what was known belongs to another time.
  void begin_anew(const std::string& why);
  Hypothesis whole() const;       // the belief as one Gaussian
  double position_sigma() const;  // m, the larger axis

  robot::RfidDescription rfid_;
  LocalizerParameters parameters_;
  Floor floor_;
  InputTimes odometry_times_;
  EncoderCounters counters_;
  WheelHistory history_;
  MotionChoice motion_;
  InputTimes round_times_;
  PaperMethod paper_;
  Belief belief_;
  Trust trust_;
  LocalizerFaults faults_;  // but for the counters' jumps
};

}  // namespace markservo::rfid_localizer
