#pragma once

#include "services/simulator/readers/rfid_settings.hpp"
#include "services/simulator/readers/sonar_settings.hpp"

namespace markservo::simulator {

// Settings of what the base carries to find its way.
struct ReaderSettings {
  RfidSettings rfid;
  SonarSettings sonar;
};

}  // namespace markservo::simulator
