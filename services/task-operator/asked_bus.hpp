#pragma once

#include <set>
#include <string>

namespace markservo::task_operator {

// On which bus nobody answered, and who speaks there: "asked on udpm://..., where mark-detector and simulator speak".
// `url` and `services`, names as SERVICE_STATUS has them, are shown as they are.
std::string told_of_bus(const std::string& url, const std::set<std::string>& services);

}  // namespace markservo::task_operator
