#pragma once

// A running simulator and a client on its bus, for tests on a network of their own.

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <functional>
#include <markservo/BaseCommand.hpp>
#include <markservo/JointCommand.hpp>
#include <markservo/JointState.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/SimControl.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/SonarScan.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StopRequest.hpp>
#include <markservo/StopState.hpp>
#include <markservo/WheelOdometry.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "common/bus/bus.hpp"

namespace markservo::simulator {

class SimulatorProcess {
 public:
  explicit SimulatorProcess(const std::vector<std::string>& options) {
    const std::string root = MARKSERVO_SOURCE_DIR;
    std::vector<std::string> words = {std::string(MARKSERVO_BIN_DIR) + "/simulator", "--robot-file",
                                      root + "/config/robot.yaml", "--scene", root + "/config/scenes/shelf.yaml"};
    words.insert(words.end(), options.begin(), options.end());
    std::vector<char*> arguments;
    arguments.reserve(words.size() + 1);
    for (std::string& word : words) arguments.push_back(word.data());
    arguments.push_back(nullptr);
    pid_ = fork();
    if (pid_ == 0) {
      prctl(PR_SET_PDEATHSIG, SIGKILL);  // one that outlived a crashed test would keep its runner waiting
      execv(arguments[0], arguments.data());
      _exit(127);
    }
  }
  ~SimulatorProcess() {
    if (pid_ > 0) {
      kill(pid_, SIGKILL);
      waitpid(pid_, nullptr, 0);
    }
  }
  SimulatorProcess(const SimulatorProcess&) = delete;
  SimulatorProcess& operator=(const SimulatorProcess&) = delete;

  // The exit code once it has ended.
  int wait() {
    int status = 0;
    waitpid(pid_, &status, 0);
    pid_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  int terminate() {
    kill(pid_, SIGTERM);
    return wait();
  }

 private:
  pid_t pid_ = -1;
};

// Sees all that the simulator says.
class Client {
 public:
  Client()
      : bus_(parameters()),
        commands_(bus_.advertise(channels::kJointCommand)),
        base_commands_(bus_.advertise(channels::kBaseCommand)),
        stops_(bus_.advertise(channels::kStop)),
        controls_(bus_.advertise(channels::kSimControl)) {
    bus_.on_each(channels::kSimTruth, [this](const SimTruth& message) { truths.push_back(message); });
    bus_.on_each(channels::kStereoFrame, [this](const StereoFrame& message) { frames.push_back(message); });
    bus_.on_each(channels::kJointState, [this](const JointState& message) { joints.push_back(message); });
    bus_.on_each(channels::kWheelOdometry, [this](const WheelOdometry& message) {
      odometries.push_back(message);
      if (driver) answer_odometry(message, driver(message));
    });
    bus_.on_each(channels::kSimBaseTruth, [this](const SimBaseTruth& message) { base_truths.push_back(message); });
    bus_.on_each(channels::kSonarScan, [this](const SonarScan& message) { scans.push_back(message); });
    bus_.on_each(channels::kRfidTagHits, [this](const RfidTagHits& message) { rounds.push_back(message); });
    bus_.on_each(channels::kStopState, [this](const StopState& message) { stop_states.push_back(message); });
  }

  std::vector<SimTruth> truths;
  std::vector<StereoFrame> frames;
  std::vector<JointState> joints;
  std::vector<StopState> stop_states;
  std::vector<WheelOdometry> odometries;
  std::vector<SimBaseTruth> base_truths;
  std::vector<SonarScan> scans;
  std::vector<RfidTagHits> rounds;
  // The speed (m/s) that answers each odometry as it comes; not set: none is answered.
  std::function<double(const WheelOdometry&)> driver;

  // Handles messages until `done`; throws when that takes longer than a hung process may.
  void until(const std::function<bool()>& done) {
    const auto begin = std::chrono::steady_clock::now();
    while (!done()) {
      bus_.poll(std::chrono::milliseconds(20));
      if (std::chrono::steady_clock::now() - begin > std::chrono::seconds(60)) throw std::runtime_error("no answer");
    }
  }
  void for_a_while(std::chrono::milliseconds time) {
    const auto end = std::chrono::steady_clock::now() + time;
    while (std::chrono::steady_clock::now() < end) bus_.poll(std::chrono::milliseconds(20));
  }

  // The newest frame, once there is one that this did not give before.
  const StereoFrame& next_frame() {
    until([&] { return !frames.empty() && frames.back().seq > given_seq_; });
    given_seq_ = frames.back().seq;
    return frames.back();
  }

  // The command that answers `frame`.
  void answer(const StereoFrame& frame, const std::vector<double>& position, double speed = 1.0) {
    JointCommand command{};
    command.utime = command.frame_utime = frame.utime;
    command.frame_session = frame.session;
    command.frame_seq = frame.seq;
    command.joint_session = frame.session;  // the simulator's own, as of all that it tells
    command.num_joints = static_cast<std::int32_t>(position.size());
    command.position = position;
    command.speed_limit.assign(position.size(), speed);
    command.gripper_opening = 0.04;
    command.gripper_force = 25.0;
    commands_.publish(command);
  }

  // The command that answers `odometry`.
  void answer_odometry(const WheelOdometry& odometry, double speed) {
    BaseCommand command{};
    command.utime = odometry.utime;
    command.odometry_session = odometry.session;
    command.odometry_seq = odometry.seq;
    command.speed = speed;
    base_commands_.publish(command);
  }

  // us, the world's time as last told: what a command must carry to be fresh.
  std::int64_t newest_utime() {
    until([&] { return !stop_states.empty(); });
    return std::max(stop_states.back().utime, joints.empty() ? 0 : joints.back().utime);
  }

  // STOP or its reset, until it is echoed.
  void request_stop(std::int8_t kind) {
    StopRequest request{};
    request.session = stops_.session();
    request.request_id = ++last_id_;
    request.kind = kind;
    request.source = "test";
    request.utime = newest_utime();
    stops_.publish(request);
    until([&] { return !stop_states.empty() && stop_states.back().request_id == request.request_id; });
  }

  // SIM_CONTROL, until it is echoed; the echo.
  SimTruth control(std::int8_t kind, std::int64_t seed, const std::vector<std::pair<std::string, double>>& settings) {
    SimControl message{};
    message.utime = newest_utime();
    message.session = controls_.session();
    message.control_id = ++last_id_;
    message.kind = kind;
    message.seed = seed;
    for (const auto& [name, value] : settings) {
      SimParameter parameter{};
      parameter.name = name;
      parameter.value = value;
      message.parameters.push_back(parameter);
    }
    message.num_parameters = static_cast<std::int32_t>(message.parameters.size());
    controls_.publish(message);
    until([&] { return !truths.empty() && truths.back().control_id == message.control_id; });
    return truths.back();
  }

  // Publishes again what was sent before, as senders do until they are echoed.
  void repeat_control(std::int64_t control_id, std::int8_t kind, std::int64_t seed) {
    SimControl message{};
    message.utime = newest_utime();
    message.session = controls_.session();
    message.control_id = control_id;
    message.kind = kind;
    message.seed = seed;
    controls_.publish(message);
  }

 private:
  static bus::BusParameters parameters() {
    bus::BusParameters result;
    if (const char* url = getenv("MARKSERVO_LCM_URL")) result.urls = {url, url};
    result.service_name = "test";
    return result;
  }

  bus::Bus bus_;
  bus::Publisher<JointCommand> commands_;
  bus::Publisher<BaseCommand> base_commands_;
  bus::Publisher<StopRequest> stops_;
  bus::Publisher<SimControl> controls_;
  std::int64_t last_id_ = 0;
  std::int64_t given_seq_ = 0;
};

}  // namespace markservo::simulator
