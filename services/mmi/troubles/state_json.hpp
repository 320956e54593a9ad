#pragma once

#include <nlohmann/json.hpp>
#include <vector>

#include "services/mmi/troubles/robot_state.hpp"
#include "services/mmi/troubles/trouble.hpp"

namespace markservo::mmi {

// [{"code", "subject", "since_utime", "text", "remedy"}], in the order given. Times are texts, as all 64-bit integers
// of the page's protocol.
nlohmann::ordered_json troubles_json(const std::vector<Trouble>& troubles);

// The body of /state.json: {"task", "pose", "recording", "troubles"}.
//   task       {"state" ("SERVO"), "target", "reason", "result" ("NONE"), "since_utime", "text"}; "text" is
//              RobotState::activity()
//   pose       {"x", "y" (m), "heading" (rad), "state" ("LOCALISED"), "sigma_x", "sigma_y" (m), "reason"}, of R in W
//   recording  {"folder", "recording", "bytes", "free_bytes", "parts", "why"}
// Each of the three is null while nothing was heard of it; numbers that are not finite are null.
nlohmann::ordered_json state_json(const RobotState& state, const std::vector<Trouble>& troubles);

}  // namespace markservo::mmi
