#pragma once

#include "common/robot/robot_description.hpp"
#include "tests/experiments/localisation/read_information.hpp"

namespace markservo::experiments {

// The reader and the field's tags as the robot's description has them.
ReaderModel described_reader(const robot::RfidDescription& rfid, const robot::TagField& field);

}  // namespace markservo::experiments
