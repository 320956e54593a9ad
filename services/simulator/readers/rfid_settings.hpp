#pragma once

// Settings `rfid.*`: what goes wrong between the tags in the floor and the reader's answer.

#include "common/robot/robot_description.hpp"
#include "services/simulator/settings/setting.hpp"

namespace markservo::simulator {

struct RfidReaderParameters;
struct TagFloorParameters;

struct RfidSettings {
  double missed = 0.0;
  double missing_tags = 0.0;
  double survey_error = 0.0;
  double delay_s = 0.0;
  double delay_jitter_s = 0.0;
  double read_time_known = 0.0;
  double unknown_rate = 0.0;
  double false_rate = 0.0;
  double duplicate_rate = 0.0;
};

inline constexpr Setting<RfidSettings> kRfidSettings[] = {
    {"rfid.missed", &RfidSettings::missed, 0.0, 1.0, TakesEffect::kAtOnce, "share of tag reads that fail besides"},
    {"rfid.missing_tags", &RfidSettings::missing_tags, 0.0, 1.0, TakesEffect::kAtReset,
     "share of the map's tags that are not there"},
    {"rfid.survey_error", &RfidSettings::survey_error, 0.0, 1.0, TakesEffect::kAtReset,
     "m, standard deviation of the tags' true from their mapped places, each axis"},
    {"rfid.delay_s", &RfidSettings::delay_s, 0.0, 10.0, TakesEffect::kAtOnce,
     "s, from a round's middle to its arrival"},
    {"rfid.delay_jitter_s", &RfidSettings::delay_jitter_s, 0.0, 1.0, TakesEffect::kAtOnce,
     "s, answers come up to this early or late"},
    {"rfid.read_time_known", &RfidSettings::read_time_known, 0.0, 1.0, TakesEffect::kAtOnce,
     "1: the reader tells when it read", true},
    {"rfid.unknown_rate", &RfidSettings::unknown_rate, 0.0, 1.0, TakesEffect::kAtOnce,
     "share of rounds with a tag not in the map"},
    {"rfid.false_rate", &RfidSettings::false_rate, 0.0, 1.0, TakesEffect::kAtOnce,
     "share of rounds with a tag that is far away"},
    {"rfid.duplicate_rate", &RfidSettings::duplicate_rate, 0.0, 1.0, TakesEffect::kAtOnce,
     "share of reads that are told twice"},
};

// Reader and tags as good as robot.yaml has them.
RfidSettings default_rfid_settings(const robot::RobotDescription& robot);

// Throws ConfigurationError if the reader would answer before its round is over.
void check_rfid_settings(const RfidSettings& settings, const robot::RobotDescription& robot);

RfidReaderParameters rfid_reader_parameters(const RfidSettings& settings);
TagFloorParameters tag_floor_parameters(const RfidSettings& settings);

}  // namespace markservo::simulator
