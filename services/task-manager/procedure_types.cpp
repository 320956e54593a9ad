#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

std::string describe_sight(const MarkReport& mark) {
  const std::string subject = "the mark of " + mark.name + " is ";
  return subject + (mark.sight ? name_of(*mark.sight) : "not reported by target-locator");
}

std::string describe_latched(const StopReport& stop) {
  return "stop is latched: reset it first (" + stop.reason + ")";
}

}  // namespace markservo::task_manager
