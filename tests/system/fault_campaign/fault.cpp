#include "tests/system/fault_campaign/fault.hpp"

#include <map>
#include <stdexcept>

namespace markservo::campaign {
namespace {

using Words = std::set<std::string>;

// What a service's fault shows as, in an honest reason: what it writes; of what answers frame by frame also the one
// channel further on by which the task goes; and the words by which its next life is known.
const std::map<std::string, Words>& shown_by() {
  static const std::map<std::string, Words> all = {
      // It stands for the whole robot: each of its channels may be the first that is missed.
      {"simulator",
       {"STEREO_FRAME", "JOINT_STATE", "STOP_STATE", "WHEEL_ODOMETRY", "SONAR_SCAN", "TARGET_POSE", "SERVO_STATUS",
        "the arm restarted", "the base began anew", "comes up stopped"}},
      {"mark-detector", {"MARK_DETECTION", "TARGET_POSE"}},
      {"target-locator", {"STEREO_MATCHES", "TARGET_POSE"}},
      {"visual-servo", {"JOINT_COMMAND", "SERVO_STATUS"}},
      {"rfid-localizer", {"ROBOT_POSE"}},
      {"base-navigator", {"BASE_COMMAND", "BASE_STATUS"}},
      {"task-manager", {"SERVO_GOAL", "BASE_GOAL", "TASK_STATE", "started: no task"}},
  };
  return all;
}

}  // namespace

std::set<std::string> words_of_service(const std::string& service) {
  Words words{service};
  const auto found = shown_by().find(service);
  if (found != shown_by().end()) words.insert(found->second.begin(), found->second.end());
  return words;
}

std::set<std::string> words_heard_by(const std::string& service) {
  static const std::map<std::string, Words> all = {
      {"visual-servo", {"TARGET_POSE", "STEREO_FRAME", "JOINT_STATE", "STOP_STATE", "SERVO_GOAL"}},
      {"task-manager", {"SERVO_STATUS", "BASE_STATUS", "TARGET_POSE", "JOINT_STATE", "STOP_STATE"}},
      {"base-navigator", {"WHEEL_ODOMETRY", "ROBOT_POSE", "SONAR_SCAN", "STOP_STATE", "BASE_GOAL"}},
      {"rfid-localizer", {"WHEEL_ODOMETRY", "RFID_TAG_HITS"}},
  };
  const auto found = all.find(service);
  return found == all.end() ? Words{} : found->second;
}

std::set<std::string> words_of_channel(const std::string& channel) {
  Words words{channel};
  // A person's word is quoted, not its channel: these are the trial's own.
  if (channel == "STOP") words.insert("another operator");
  if (channel == "TASK_COMMAND") words.insert("aborted by operator");
  // They are heard by rfid-localizer alone, or make its poses useless.
  if (channel == "WHEEL_ODOMETRY" || channel == "RFID_TAG_HITS") words.insert("ROBOT_POSE");
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
