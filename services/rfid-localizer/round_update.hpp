#pragma once

// What a round of the reader does to the mixture: every hypothesis is matched with the same reads and silences.

#include <cstdint>
#include <optional>
#include <vector>

#include "services/rfid-localizer/belief.hpp"
#include "services/rfid-localizer/hypothesis.hpp"
#include "services/rfid-localizer/motion.hpp"
#include "services/rfid-localizer/round_match.hpp"
#include "services/rfid-localizer/tag_map.hpp"
#include "services/rfid-localizer/tag_reliability.hpp"

namespace markservo::rfid_localizer {

// A tag of the map that answered.
struct HeardTag {
  int tag = 0;
  std::optional<std::int64_t> moment;  // us, when, if the reader tells it
};

struct RoundTime {
  std::int64_t middle = 0;  // us, of the reading
  std::int64_t length = 0;  // us
  bool known = false;       // told by the reader; else by the delay, which the round then tells something of
  double delay = 0.0;       // s, that the middle was told by, unless known
};

// The tags of the floor, and how they are read.
struct Floor {
  TagMap map;
  ReadModel model;
  TagReliability reliability;
};

// What the mixture makes of a tag near one of its hypotheses.
struct TagTally {
  int tag = 0;
  bool read = false;
  double inside = 0.0;  // probability that it was well inside the footprint, given the round
  double chance = 0.0;  // probability that it was to be read, before
};

struct RoundUpdate {
  Mixture mixture;             // with weights that do not add up to 1
  double probability = 0.0;    // of what was read and what was not, before
  std::vector<TagTally> tags;  // near any hypothesis
};

// Where the antenna was in the round's true middle, by a hypothesis for `utime` (us): later than that by what the
// mixture has not been led up to, and by what the delay is shorter than the one that the middle was told by.
AntennaView antenna_in_the_middle(const Hypothesis& hypothesis, std::int64_t utime, const Motion& motion,
                                  const RoundTime& time);

// `belief`, which is not empty, after the round in which `heard` answered.
RoundUpdate update(const Belief& belief, const Motion& motion, const RoundTime& time,
                   const std::vector<HeardTag>& heard, const Floor& floor, const RoundMatchParameters& parameters);

}  // namespace markservo::rfid_localizer
