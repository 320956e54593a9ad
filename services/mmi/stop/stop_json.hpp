#pragma once

#include <nlohmann/json.hpp>

#include "services/mmi/stop/stop_requester.hpp"

namespace markservo::mmi {

// `stop` of an update: {"state", "request" (text), "devices": [{"device", "state", "latched" (null: not known),
// "reason"}]}.
nlohmann::ordered_json stop_json(const StopView& view);

}  // namespace markservo::mmi
