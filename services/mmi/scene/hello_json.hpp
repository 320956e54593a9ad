#pragma once

#include <nlohmann/json.hpp>

namespace markservo::mmi {

// What a hello says of the channels and states, all that this program was built with: {channels, phases, transitions,
// states}. Names by number are those of the message types' constants.
nlohmann::ordered_json vocabulary_json();

}  // namespace markservo::mmi
