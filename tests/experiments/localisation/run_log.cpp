#include "tests/experiments/localisation/run_log.hpp"

#include <lcm/lcm-cpp.hpp>
#include <markservo/RfidTagHits.hpp>
#include <markservo/RobotPose.hpp>
#include <markservo/SimBaseTruth.hpp>
#include <markservo/WheelOdometry.hpp>
#include <markservo/channels.hpp>
#include <stdexcept>

#include "common/bus/safe_decode.hpp"
#include "services/simulator/messages/base_messages.hpp"

namespace markservo::experiments {
namespace {

constexpr std::int64_t kSession = 1;  // a log has one writer of each channel

class LogWriter {
 public:
  explicit LogWriter(const std::string& file) : file_(file), log_(file, "w") {
    if (!log_.good()) throw std::runtime_error(file + ": cannot be written");
  }

  template <class M>
  void write(const std::string& channel, const M& message) {
    std::vector<char> data(static_cast<std::size_t>(message.getEncodedSize()));
    message.encode(data.data(), 0, static_cast<int>(data.size()));
    lcm::LogEvent event{};
    event.eventnum = number_++;
    event.timestamp = message.utime;
    event.channel = channel;
    event.datalen = static_cast<std::int32_t>(data.size());
    event.data = data.data();
    if (log_.writeEvent(&event) != 0) throw std::runtime_error(file_ + ": cannot be written");
  }

 private:
  std::string file_;
  lcm::LogFile log_;
  std::int64_t number_ = 0;
};

SimBaseTruth truth_message(const PathPoint& truth, std::int64_t utime, std::int64_t seq) {
  SimBaseTruth message = simulator::base_truth_message(
      {{truth.p_WR.x(), truth.p_WR.y(), truth.heading}, truth.speed, truth.turn_rate}, utime, seq);
  message.session = kSession;
  message.seq = seq;
  return message;
}

}  // namespace

void write_log(const Drive& drive, bool with_odometry, const std::string& file) {
  LogWriter log(file);
  std::size_t next_round = 0;
  for (std::size_t i = 0; i < drive.odometry.size(); ++i) {
    const std::int64_t utime = drive.odometry[i].utime;
    const auto seq = static_cast<std::int64_t>(i);
    for (; next_round < drive.rounds.size() && drive.rounds[next_round].utime <= utime; ++next_round) {
      RfidTagHits hits = simulator::rfid_message(drive.rounds[next_round]);
      hits.session = kSession;
      hits.seq = static_cast<std::int64_t>(next_round);
      log.write(channels::kRfidTagHits.name, hits);
    }
    if (with_odometry) {
      WheelOdometry odometry = simulator::odometry_message(drive.odometry[i]);
      odometry.session = kSession;
      odometry.seq = seq;
      log.write(channels::kWheelOdometry.name, odometry);
    }
    log.write(channels::kSimBaseTruth.name, truth_message(drive.truth[i], utime, seq));
  }
}

std::vector<RobotPose> read_poses(const std::string& file) {
  lcm::LogFile log(file, "r");
  if (!log.good()) throw std::runtime_error(file + ": cannot be read");
  std::vector<RobotPose> poses;
  while (const lcm::LogEvent* event = log.readNextEvent()) {
    if (event->channel != channels::kRobotPose.name) continue;
    const auto decoded = bus::safe_decode<RobotPose>(event->data, static_cast<std::size_t>(event->datalen));
    if (!decoded.ok) throw std::runtime_error(file + ": a ROBOT_POSE that cannot be decoded");
    poses.push_back(decoded.message);
  }
  return poses;
}

}  // namespace markservo::experiments
