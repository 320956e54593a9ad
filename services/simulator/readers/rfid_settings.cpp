#include "services/simulator/readers/rfid_settings.hpp"

#include "services/simulator/readers/rfid_reader_model.hpp"
#include "services/simulator/readers/tag_floor.hpp"

namespace markservo::simulator {

RfidSettings default_rfid_settings(const robot::RobotDescription& robot) {
  RfidSettings settings;
  if (robot.rfid) settings.delay_s = robot.rfid->delay;
  if (robot.floor_tags) settings.survey_error = robot.floor_tags->survey_sigma;
  return settings;
}

void check_rfid_settings(const RfidSettings& settings, const robot::RobotDescription& robot) {
  if (!robot.rfid || settings.delay_s >= 0.5 * robot.rfid->round_time) return;
  refuse_setting("rfid.delay_s", setting_text(settings.delay_s),
                 "half of robot.yaml's rfid.round_time, " + setting_text(0.5 * robot.rfid->round_time) + ", or more");
}

RfidReaderParameters rfid_reader_parameters(const RfidSettings& settings) {
  RfidReaderParameters parameters;
  parameters.delay = settings.delay_s;
  parameters.delay_jitter = settings.delay_jitter_s;
  parameters.missed = settings.missed;
  parameters.duplicates = settings.duplicate_rate;
  parameters.unknown_tags = settings.unknown_rate;
  parameters.false_reads = settings.false_rate;
  parameters.read_time_known = settings.read_time_known != 0.0;
  return parameters;
}

TagFloorParameters tag_floor_parameters(const RfidSettings& settings) {
  return {settings.missing_tags, settings.survey_error};
}

}  // namespace markservo::simulator
