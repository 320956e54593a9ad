#pragma once

// Where the robot is, by the floor's tags: an assumed density filter. Each round of the reader is matched where the
// antenna was in its middle, a delay before its answer came; from there the wheels, or inertia, lead to now. No clock:
// every time is a message's. The same inputs in the same order give the same estimates.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "services/rfid-localizer/encoder_counters.hpp"
#include "services/rfid-localizer/free_motion.hpp"
#include "services/rfid-localizer/paper_method.hpp"
#include "services/rfid-localizer/round_update.hpp"
#include "services/rfid-localizer/tag_map.hpp"
#include "services/rfid-localizer/tag_reliability.hpp"
#include "services/rfid-localizer/trust.hpp"
#include "services/rfid-localizer/wheel_judge.hpp"
#include "services/rfid-localizer/wheel_motion.hpp"

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
  WheelJudgeParameters judge;
  bool judge_wheels = true;  // and widen the prediction where they are worse than stated
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

// Messages that come late one after another are not late: the clock was set back.
class Lateness {
 public:
  // Another late one. True when there are so many that their time is the time now.
  bool persists() { return ++in_a_row_ > kMost; }
  void passed() { in_a_row_ = 0; }

 private:
  static constexpr int kMost = 20;
  int in_a_row_ = 0;
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

  bool has_wheels() const { return motion_ == &wheel_motion_; }
  LocalizerFaults faults() const;
  WheelJudgement wheel_judgement() const { return judge_.judgement(); }
  const TagReliability& reliability() const { return reliability_; }

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
  // Moves the mixture on to `utime` (us), and what is judged of the wheels with it.
  void predict_to(std::int64_t utime);
  void judge(const Hypothesis& before, const Hypothesis& after, const RoundTime& time);
  // Gives up what is believed of the place.
  void lose(const std::string& why);
  // Likewise, and what was known belongs to another time.
  void begin_anew(const std::string& why);
  Hypothesis whole() const;       // the mixture as one Gaussian
  double position_sigma() const;  // m, the larger axis

  robot::RfidDescription rfid_;
  LocalizerParameters parameters_;
  TagMap map_;
  ReadModel model_;
  TagReliability reliability_;
  EncoderCounters counters_;
  WheelHistory history_;
  WheelMotionModel wheel_motion_;
  FreeMotionModel free_motion_;
  WheelJudge judge_;
  const Motion* motion_;
  PaperMethod paper_;
  std::optional<PaperEstimate> paper_estimate_;

  Mixture mixture_;                 // empty: not placed
  std::int64_t mixture_utime_ = 0;  // us, the time it is for
  Trust trust_;
  std::optional<std::int64_t> last_round_;
  std::int64_t wheel_session_ = 0;
  std::int64_t reader_session_ = 0;
  Lateness late_odometry_, late_rounds_;
  LocalizerFaults faults_;  // but for the counters' jumps
};

}  // namespace markservo::rfid_localizer
