#include "services/simulator/world/mobile_base.hpp"

#include <utility>

#include "services/simulator/model/time_step.hpp"
#include "services/simulator/random.hpp"

namespace markservo::simulator {
namespace {

static_assert(BaseRig::kStep_us == kTimeStep_us, "base and world take the same steps");

BaseRigParameters rig_parameters(const BaseSettings& base, const RfidSettings& rfid, const std::string& tag_field) {
  return {base_model_parameters(base), tag_floor_parameters(rfid), rfid_reader_parameters(rfid), tag_field};
}

}  // namespace

MobileBase::MobileBase(const robot::RobotDescription& robot, const std::string& tag_field, const BaseSettings& base,
                       const ReaderSettings& readers, std::uint64_t seed, std::int64_t epoch)
    : rig_(robot, rig_parameters(base, readers.rfid, tag_field), base.start(), seed, epoch),
      sonar_parameters_(sonar_parameters(readers.sonar)),
      next_scan_(epoch) {
  if (robot.sonars) sonars_.emplace(*robot.sonars, seed_for(seed, streams::kSonars, 0));
}

void MobileBase::change(const ReaderSettings& readers) {
  rig_.change_reader(rfid_reader_parameters(readers.rfid));
  sonar_parameters_ = sonar_parameters(readers.sonar);
}

void MobileBase::step(World& world) {
  rig_.step();
  world.move_base(rig_.truth().pose);
  world.step();
  touched_ = touched_ || world.clearance() <= 0.0;
}

MobileBaseOutputs MobileBase::take_due(World& world) {
  BaseOutputs due = rig_.take_due();
  MobileBaseOutputs outputs{std::move(due.rounds), std::nullopt, due.odometry};
  if (sonars_ && rig_.utime() >= next_scan_) {
    outputs.scan = sonars_->listen(world.cast_rays(sonars_->rays()), sonar_parameters_, rig_.utime());
    next_scan_ += kScanPeriod_us;
  }
  return outputs;
}

MobileBaseTruth MobileBase::truth(const World& world) const {
  return {rig_.truth(), touched_, world.clearance()};
}

}  // namespace markservo::simulator
