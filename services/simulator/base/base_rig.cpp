#include "services/simulator/base/base_rig.hpp"

#include <stdexcept>
#include <utility>

#include "common/robot/configuration_error.hpp"
#include "services/simulator/random.hpp"

namespace markservo::simulator {
namespace {

const robot::BaseDescription& base_of(const robot::RobotDescription& robot) {
  if (robot.base) return *robot.base;
  throw ConfigurationError("the robot has no base; allowed: a robot.yaml with section 'base'");
}

OdometryReading reading(const BaseModel& base, std::int64_t utime) {
  return {utime, base.ticks(), base.left_distance(), base.right_distance()};
}

}  // namespace

BaseRig::BaseRig(const robot::RobotDescription& robot, const BaseRigParameters& parameters,
                 const geometry::PlanePose& start, std::uint64_t seed, std::int64_t epoch)
    : epoch_(epoch), utime_(epoch), base_(base_of(robot), parameters.base, start, seed_for(seed, streams::kBase, 0)) {
  if (epoch <= 0) throw std::invalid_argument("BaseRig: epoch is " + std::to_string(epoch) + "; allowed: above 0 us");
  if (robot.rfid && robot.floor_tags) {
    TagFloor floor(robot.floor_tags->field(parameters.tag_field), parameters.floor,
                   seed_for(seed, streams::kTagFloor, 0));
    reader_.emplace(*robot.rfid, parameters.reader, std::move(floor), seed_for(seed, streams::kTagReader, 0));
    reader_->observe(utime_, start);
  }
  due_.odometry = reading(base_, utime_);
}

void BaseRig::command(double speed, double turn_rate) {
  base_.command(speed, turn_rate);
  commanded_utime_ = utime_;
}

void BaseRig::freeze() {
  base_.freeze();
  commanded_utime_.reset();
}

void BaseRig::change_reader(const RfidReaderParameters& parameters) {
  if (reader_) reader_->change(parameters);
}

void BaseRig::step() {
  if (commanded_utime_ && utime_ - *commanded_utime_ >= kCommandTimeout_us) freeze();
  base_.step(static_cast<double>(kStep_us) * 1e-6);
  utime_ += kStep_us;
  if (reader_) {
    reader_->observe(utime_, base_.pose());
    for (TagRound& round : reader_->take_arrived(utime_)) due_.rounds.push_back(std::move(round));
  }
  if ((utime_ - epoch_) % kOdometryPeriod_us == 0) due_.odometry = reading(base_, utime_);
}

BaseOutputs BaseRig::take_due() {
  return std::exchange(due_, {});
}

}  // namespace markservo::simulator
