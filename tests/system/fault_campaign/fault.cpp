#include "tests/system/fault_campaign/fault.hpp"

#include <map>
#include <stdexcept>

namespace markservo::campaign {
namespace {

using Words = std::set<std::string>;

// Who reads what is silent can only tell what he reads: a dead mark-detector shows as a TARGET_POSE that is too old.
const std::map<std::string, Words>& written() {
  static const std::map<std::string, Words> all = {
      {"simulator",
       {"STEREO_FRAME", "JOINT_STATE", "STOP_STATE", "WHEEL_ODOMETRY", "SONAR_SCAN", "RFID_TAG_HITS", "TARGET_POSE",
        "SERVO_STATUS", "ROBOT_POSE", "BASE_STATUS", "stop device"}},
      {"mark-detector", {"MARK_DETECTION", "TARGET_POSE", "SERVO_STATUS"}},
      {"target-locator", {"TARGET_POSE", "STEREO_MATCHES", "SERVO_STATUS"}},
      {"visual-servo", {"JOINT_COMMAND", "SERVO_STATUS"}},
      {"rfid-localizer", {"ROBOT_POSE", "BASE_STATUS"}},
      {"base-navigator", {"BASE_COMMAND", "BASE_STATUS"}},
      {"task-manager", {"SERVO_GOAL", "BASE_GOAL", "TASK_STATE", "started: no task"}},
  };
  return all;
}

}  // namespace

std::set<std::string> words_of_service(const std::string& service) {
  Words words{service};
  const auto found = written().find(service);
  if (found != written().end()) words.insert(found->second.begin(), found->second.end());
  return words;
}

std::set<std::string> words_of_channel(const std::string& channel) {
  Words words{channel};
  // A person's word is quoted, not its channel.
  if (channel == "STOP" || channel == "STOP_STATE") words.insert({"STOP", "stop", "latched"});
  if (channel == "TASK_COMMAND") words.insert({"ABORT", "abort", "START"});
  if (channel == "JOINT_STATE" || channel == "STOP_STATE") words.insert("SERVO_STATUS");
  if (channel == "TARGET_POSE") words.insert({"SERVO_STATUS", "mark"});
  if (channel == "WHEEL_ODOMETRY" || channel == "SONAR_SCAN" || channel == "ROBOT_POSE" || channel == "RFID_TAG_HITS") {
    words.insert({"ROBOT_POSE", "BASE_STATUS", "base"});
  }
  return words;
}

std::unique_ptr<Fault> make_fault(const FaultPlan& plan) {
  for (const auto& make : {make_writer_fault, make_old_messages, make_process_fault, make_network_fault,
                           make_clock_fault, make_device_fault}) {
    if (auto fault = make(plan)) return fault;
  }
  throw std::logic_error("no fault of kind '" + plan.kind + "'");
}

}  // namespace markservo::campaign
