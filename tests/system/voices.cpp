// What a robot does when others speak in its bus; for tests.
//   voices two-senders   two programs each give the arm and the base goals of their own, at 5 Hz, the second begins
//                        later. Says how often what moves changed from one to the other, and after how many of its
//                        goals the second was named. The robot must be released
//   voices rest          listens; says whether the simulator that speaks first was released and how far it moved
// Each says it in one line of JSON.

#include <markservo/BaseGoal.hpp>
#include <markservo/BaseStatus.hpp>
#include <markservo/JointState.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/ServoGoal.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/StopState.hpp>
#include <markservo/WheelOdometry.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>

#include "common/bus/bus.hpp"
#include "common/bus/bus_url.hpp"
#include "common/bus/option_checks.hpp"

namespace markservo {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kRepeat(200);
constexpr milliseconds kListen(20);
constexpr double kApart_rad = 0.1;  // how far from the start each one wants the arm
constexpr double kApart_m = 0.2;    // likewise the base

std::string url = bus::kDefaultUrl;

bus::BusParameters parameters(const std::string& name) {
  bus::BusParameters result;
  result.urls = {url, url};
  result.service_name = name;
  result.heartbeat = false;
  return result;
}

// What is known of the robot.
struct Robot {
  JointState joints{};
  std::optional<JointState> start;
  WheelOdometry wheels{};
};

// One of the two.
class GoalSender {
 public:
  GoalSender(const std::string& name, double side)
      : bus_(parameters(name)),
        servo_goals_(bus_.advertise(channels::kServoGoal)),
        base_goals_(bus_.advertise(channels::kBaseGoal)),
        side_(side) {}

  std::int64_t session() const { return servo_goals_.session(); }

  void send(const Robot& robot) {
    ServoGoal goal{};
    goal.utime = robot.joints.utime;
    goal.goal_id = 1;
    goal.kind = ServoGoal::POSTURE;
    goal.speed = 0.0;
    goal.num_joints = robot.start->num_joints;
    goal.position = robot.start->position;
    goal.position[0] += side_ * kApart_rad;
    goal.gripper_opening = robot.start->gripper_opening;
    goal.gripper_force = 1.0;
    servo_goals_.publish(goal);
    BaseGoal drive{};
    drive.utime = robot.wheels.utime;
    drive.session = base_goals_.session();
    drive.goal_id = 1;
    drive.kind = BaseGoal::DRIVE;
    drive.frame = BaseGoal::ROBOT;
    drive.pose.x = side_ * kApart_m;
    base_goals_.publish(drive);
  }

 private:
  bus::Bus bus_;
  bus::Publisher<ServoGoal> servo_goals_;
  bus::Publisher<BaseGoal> base_goals_;
  double side_;
};

// Whom one mover follows.
struct Followed {
  std::int64_t session = 0;
  int changes = 0;
  std::set<std::int64_t> all;
  std::optional<int> named_after;  // goals of the second, until its SERVICE_STATUS named it

  void hear(std::int64_t goal_session) {
    if (goal_session == 0) return;
    if (session != 0 && goal_session != session) ++changes;
    session = goal_session;
    all.insert(goal_session);
  }
  nlohmann::json json() const {
    nlohmann::json result = {{"changes", changes}, {"followed", all.size()}, {"named_after", nullptr}};
    if (named_after) result["named_after"] = *named_after;
    return result;
  }
};

int send_goals(double seconds, double head_start) {
  bus::Bus bus(parameters("two-senders"));
  GoalSender first("first-sender", 1.0);
  GoalSender second("second-sender", -1.0);
  Robot robot;
  std::map<std::string, Followed> followed{{"visual-servo", {}}, {"base-navigator", {}}};
  int second_sent = 0;
  bus.on_each(channels::kJointState, [&](const JointState& joints) { robot.joints = joints; });
  bus.on_each(channels::kWheelOdometry, [&](const WheelOdometry& wheels) { robot.wheels = wheels; });
  bus.on_each(channels::kServoStatus,
              [&](const ServoStatus& status) { followed["visual-servo"].hear(status.goal_session); });
  bus.on_each(channels::kBaseStatus,
              [&](const BaseStatus& status) { followed["base-navigator"].hear(status.goal_session); });
  bus.on_each(channels::kServiceStatus, [&](const ServiceStatus& status) {
    const auto mover = followed.find(status.name);
    if (mover == followed.end() || second_sent == 0 || mover->second.named_after) return;
    if (status.reason.find(std::to_string(second.session())) == std::string::npos) return;
    mover->second.named_after = second_sent;
  });
  const auto asked = steady_clock::now();
  std::optional<steady_clock::time_point> began;
  auto next = asked;
  const auto since = [](steady_clock::time_point moment) {
    return std::chrono::duration<double>(steady_clock::now() - moment).count();
  };
  while (since(began.value_or(asked)) < head_start + seconds) {
    bus.poll(kListen);
    if (robot.joints.utime == 0 || robot.wheels.utime == 0) continue;
    if (!robot.start) robot.start = robot.joints;
    if (steady_clock::now() < next) continue;
    next = steady_clock::now() + kRepeat;
    first.send(robot);
    if (!began) began = steady_clock::now();
    if (since(*began) < head_start) continue;
    ++second_sent;
    second.send(robot);
  }
  if (!robot.start) {
    std::fprintf(stderr, "two-senders: no JOINT_STATE and WHEEL_ODOMETRY within %.0f s\n", head_start + seconds);
    return 1;
  }
  const nlohmann::json result = {{"arm", followed["visual-servo"].json()}, {"base", followed["base-navigator"].json()}};
  std::puts(result.dump().c_str());
  return 0;
}

// One simulator's world.
struct World {
  std::int64_t session = 0;
  std::optional<SimTruth> arm;       // as it was first
  std::optional<SimBaseTruth> base;  // likewise
  double moved_rad = 0.0;
  double moved_m = 0.0;
  bool released = false;

  bool is(std::int64_t of) {
    if (session == 0) session = of;
    return of == session;
  }
  void hear(const SimTruth& truth) {
    if (!is(truth.session)) return;
    if (!arm) arm = truth;
    for (std::size_t i = 0; i < std::min(arm->shaft.size(), truth.shaft.size()); ++i) {
      moved_rad = std::max(moved_rad, std::abs(truth.shaft[i] - arm->shaft[i]));
    }
  }
  void hear(const SimBaseTruth& truth) {
    if (!is(truth.session)) return;
    if (!base) base = truth;
    moved_m = std::max(moved_m, std::hypot(truth.pose.x - base->pose.x, truth.pose.y - base->pose.y));
  }
  void hear(const StopState& stop) {
    if (stop.session == session && stop.latched == 0) released = true;
  }
};

int watch_rest(double seconds) {
  bus::Bus bus(parameters("rest"));
  World world;
  bus.on_each(channels::kSimTruth, [&](const SimTruth& truth) { world.hear(truth); });
  bus.on_each(channels::kSimBaseTruth, [&](const SimBaseTruth& truth) { world.hear(truth); });
  bus.on_each(channels::kStopState, [&](const StopState& stop) { world.hear(stop); });
  std::optional<steady_clock::time_point> began;
  const auto asked = steady_clock::now();
  constexpr std::chrono::seconds kPatience(60);
  while (!began || std::chrono::duration<double>(steady_clock::now() - *began).count() < seconds) {
    bus.poll(kListen);
    if (!began && world.arm && world.base) {
      began = steady_clock::now();
      std::puts("watching");
      std::fflush(stdout);
    }
    if (!began && steady_clock::now() - asked > kPatience) {
      std::fprintf(stderr, "voices: no SIM_TRUTH and SIM_BASE_TRUTH within 60 s\n");
      return 1;
    }
  }
  const nlohmann::json result = {
      {"released", world.released}, {"moved_rad", world.moved_rad}, {"moved_m", world.moved_m}};
  std::puts(result.dump().c_str());
  return 0;
}

}  // namespace
}  // namespace markservo

int main(int argc, char** argv) {
  double seconds = 10.0;
  double head_start = 2.0;
  CLI::App app("What a robot does when others speak on its bus", "voices");
  app.require_subcommand(1);
  app.add_option("--lcm-url", markservo::url, "LCM bus")->envname("MARKSERVO_LCM_URL")->capture_default_str();
  const auto add_seconds = [&seconds](CLI::App* command, const char* what) {
    command->add_option("--seconds", seconds, what)->check(markservo::bus::Within(0.5, 600.0))->capture_default_str();
  };
  CLI::App* senders = app.add_subcommand("two-senders", "Two programs give the same robot goals of their own");
  add_seconds(senders, "So long both send");
  senders->add_option("--head-start", head_start, "So long the first one sends alone, s")
      ->check(markservo::bus::Within(0.0, 60.0))
      ->capture_default_str();
  CLI::App* rest = app.add_subcommand("rest", "Whether a simulator stays latched and where it is");
  add_seconds(rest, "So long it is watched");
  CLI11_PARSE(app, argc, argv);
  return *senders ? markservo::send_goals(seconds, head_start) : markservo::watch_rest(seconds);
}
