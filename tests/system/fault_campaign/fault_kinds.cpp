#include "tests/system/fault_campaign/fault_kinds.hpp"

#include <cmath>

namespace markservo::campaign {
namespace {

using Names = std::vector<std::string>;

const Names kServices = {"simulator",      "rfid-localizer", "base-navigator", "mark-detector",
                         "target-locator", "visual-servo",   "task-manager"};

// Whoever writes there a second time.
const Names kWritten = {"JOINT_STATE",   "STOP_STATE",    "WHEEL_ODOMETRY", "SONAR_SCAN",    "ROBOT_POSE",
                        "TARGET_POSE",   "SERVO_GOAL",    "SERVO_STATUS",   "JOINT_COMMAND", "BASE_GOAL",
                        "BASE_STATUS",   "BASE_COMMAND",  "TASK_STATE",     "TASK_COMMAND",  "STOP",
                        "RFID_TAG_HITS", "SERVICE_STATUS"};
// What moves the robot, or what a mover goes by: half of the second writers speak there.
const Names kMoving = {"JOINT_STATE",  "JOINT_COMMAND", "SERVO_GOAL", "STOP_STATE",     "BASE_GOAL",
                       "BASE_COMMAND", "TASK_COMMAND",  "STOP",       "WHEEL_ODOMETRY", "TARGET_POSE"};
// Streams, of which some come late, twice or in another order.
const Names kStreams = {"JOINT_STATE", "STOP_STATE",   "WHEEL_ODOMETRY", "SONAR_SCAN",    "ROBOT_POSE",
                        "TARGET_POSE", "SERVO_GOAL",   "SERVO_STATUS",   "JOINT_COMMAND", "BASE_GOAL",
                        "BASE_STATUS", "BASE_COMMAND", "TASK_STATE",     "RFID_TAG_HITS"};
const Names kTexts = {"STOP",         "TASK_COMMAND", "STOP_STATE", "SERVICE_STATUS", "TASK_STATE",
                      "SERVO_STATUS", "BASE_STATUS",  "ROBOT_POSE", "TARGET_POSE",    "SERVO_GOAL"};

// Log-uniform.
double between_orders(Random& random, double low, double high) {
  return low * std::pow(high / low, random.uniform());
}

double hang_time(Random& random) {
  // Long ones cost the campaign's time and show little more: 1 in 20.
  return random.chance(0.05) ? random.between(10.0, 60.0) : between_orders(random, 0.1, 10.0);
}

void second_writer(Random& random, FaultPlan& fault) {
  fault.channel = random.one_of(random.chance(0.5) ? kMoving : kWritten);
  fault.rate = random.one_of<double>({1.0, 10.0, 100.0});
  fault.same_session = random.chance(0.3);
  fault.duration = random.between(1.0, 4.0);
  fault.amount = random.between(0.1, 0.5);
}

void second_process(Random& random, FaultPlan& fault) {
  fault.service = random.one_of(kServices);
  fault.variant = random.one_of<std::string>({"stack", "process"});
  fault.duration = 6.0;
}

void old_messages(Random& random, FaultPlan& fault) {
  fault.channel = random.chance(0.4) ? "all" : random.one_of(kWritten);
  fault.variant = random.one_of<std::string>({"warm", "fresh", "latched"});
  fault.amount = between_orders(random, 60.0, 1e6);  // s old
  // What was killed needs some seconds until it can be fooled.
  fault.duration = random.between(2.0, 4.0) + (fault.variant == "fresh" ? 5.0 : 0.0);
}

void late_copies(Random& random, FaultPlan& fault) {
  fault.channel = random.one_of(kStreams);
  fault.percent = between_orders(random, 1.0, 30.0);
  fault.delay = random.chance(0.2) ? 0.0 : between_orders(random, 0.005, 0.2);
  fault.duration = random.between(3.0, 8.0);
}

void relayed(Random& random, FaultPlan& fault) {
  fault.service = random.one_of<std::string>({"visual-servo", "task-manager", "base-navigator", "rfid-localizer"});
  fault.variant = random.one_of<std::string>({"late", "reordered", "lost"});
  fault.percent = between_orders(random, 1.0, 30.0);
  fault.delay = between_orders(random, 0.005, 0.2);
  fault.duration = random.between(3.0, 8.0);
}

void clock_step(Random& random, FaultPlan& fault) {
  fault.service = random.chance(0.3) ? "all" : random.one_of(kServices);
  fault.variant = random.one_of<std::string>({"wall", "stamps"});
  if (fault.variant == "stamps")
    fault.service = random.one_of<std::string>({"visual-servo", "task-manager", "base-navigator", "rfid-localizer"});
  fault.amount = random.one_of<double>({-3600.0, -1.0, 1.0, 3600.0});
  fault.duration = random.between(1.0, 4.0);
}

void clock_drift(Random& random, FaultPlan& fault) {
  fault.service = random.chance(0.3) ? "all" : random.one_of(kServices);
  fault.amount = random.one_of<double>({0.99, 0.999, 1.001, 1.01});
  fault.duration = random.between(3.0, 8.0);
}

void hang(Random& random, FaultPlan& fault) {
  fault.service = random.one_of(kServices);
  fault.duration = hang_time(random);
}

void kill(Random& random, FaultPlan& fault) {
  fault.service = random.one_of(kServices);
  fault.duration = 0.2;
}

void crash_loop(Random& random, FaultPlan& fault) {
  fault.service = random.one_of(kServices);
  fault.duration = random.between(2.0, 8.0);
}

void no_descriptors(Random& random, FaultPlan& fault) {
  fault.service = random.one_of(kServices);
  fault.amount = static_cast<double>(4 + random.below(8));
  fault.duration = random.between(2.0, 4.0);
}

void refused_publish(Random& random, FaultPlan& fault) {
  fault.percent = random.one_of<double>({5.0, 30.0, 100.0});
  fault.duration = between_orders(random, 0.1, 5.0);
}

void route_gone(Random& random, FaultPlan& fault) {
  fault.duration = random.chance(0.05) ? random.between(10.0, 30.0) : between_orders(random, 0.1, 10.0);
}

void loss(Random& random, FaultPlan& fault) {
  fault.percent = between_orders(random, 1.0, 50.0);
  fault.duration = random.between(2.0, 6.0);
}

void fragments(Random& random, FaultPlan& fault) {
  fault.channel = random.one_of(kWritten);
  fault.variant = random.one_of<std::string>({"once", "repeated"});
  fault.duration = fault.variant == "once" ? 0.2 : random.between(1.0, 7.0);
}

void extremes(Random& random, FaultPlan& fault) {
  fault.channel = random.one_of(kWritten);
  fault.same_session = random.chance(0.3);
  fault.rate = 50.0;
  fault.duration = random.between(2.0, 4.0);
}

void long_text(Random& random, FaultPlan& fault) {
  fault.channel = random.chance(0.4) ? "STOP" : random.one_of(kTexts);
  fault.amount = between_orders(random, 50.0, 8e6);  // bytes
  fault.same_session = random.chance(0.3);
  fault.rate = 1.0;
  fault.duration = random.between(0.5, 2.0);
}

void disk(Random& random, FaultPlan& fault) {
  fault.service = random.one_of<std::string>({"services", "recording"});
  fault.duration = random.between(2.0, 5.0);
}

void lying_sensor(Random& random, FaultPlan& fault) {
  fault.variant = random.one_of<std::string>(
      {"faults.frozen_joint", "faults.frozen_camera", "faults.stuck_encoder", "faults.reversed_encoder"});
  fault.amount = static_cast<double>(1 + random.below(fault.variant == "faults.frozen_joint" ? 3 : 2));
  if (fault.variant == "faults.frozen_camera") fault.amount = 1.0;
  fault.duration = between_orders(random, 0.5, 8.0);
}

void nothing_to_draw(Random& random, FaultPlan& fault) {
  fault.duration = between_orders(random, 0.1, 5.0);
}

}  // namespace

const std::vector<KindOfFault>& kinds_of_fault() {
  static const std::vector<KindOfFault> all = {
      {"second-writer", 5.0, second_writer},
      {"second-process", 1.0, second_process},
      {"old-messages", 3.0, old_messages},
      {"late-copies", 2.5, late_copies},
      {"relay", 1.5, relayed},
      {"clock-step", 2.0, clock_step},
      {"clock-drift", 0.5, clock_drift},
      {"hang", 2.5, hang},
      {"kill", 1.5, kill},
      {"crash-loop", 1.0, crash_loop},
      {"no-descriptors", 0.7, no_descriptors},
      {"refused-publish", 1.5, refused_publish},
      {"route-gone", 1.5, route_gone},
      {"interface-gone", 0.7, nothing_to_draw},
      {"loss", 1.5, loss},
      {"fragments", 1.0, fragments},
      {"extremes", 2.0, extremes},
      {"text", 2.0, long_text},
      {"disk-full", 0.7, disk},
      {"read-only", 0.5, disk},
      {"lying-sensor", 1.5, lying_sensor},
  };
  return all;
}

}  // namespace markservo::campaign
