#pragma once

#include <string>
#include <vector>

namespace markservo::mmi {

// The names by number of the constants that name `field` of one of our message types, as written there: {"IDLE",
// "LOOK", ...}. Throws std::invalid_argument if there is no such type or field.
std::vector<std::string> state_names(const std::string& type, const std::string& field);

}  // namespace markservo::mmi
