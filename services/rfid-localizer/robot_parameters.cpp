#include "services/rfid-localizer/robot_parameters.hpp"

namespace markservo::rfid_localizer {

LocalizerParameters parameters_of(const robot::RobotDescription& robot, double slip_margin) {
  LocalizerParameters parameters;
  parameters.delay = {robot.rfid->delay, robot.rfid->delay_sigma};
  parameters.paper.delay = robot.rfid->delay;
  parameters.survey_sigma = robot.floor_tags->survey_sigma;
  parameters.reliability.read_probability = robot.rfid->read_probability;
  parameters.judge->slip_margin = slip_margin;
  if (robot.base) {
    WheelNoise& noise = parameters.wheels.noise;
    noise.track = robot.base->track;
    noise.drift = slip_margin * robot.base->drift;
    noise.pivot_wander = robot.base->pivot_wander;
    parameters.wheels.scale_sigma = robot.base->scale_sigma;
  }
  return parameters;
}

}  // namespace markservo::rfid_localizer
