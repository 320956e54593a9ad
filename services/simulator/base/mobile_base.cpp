#include "services/simulator/base/mobile_base.hpp"

#include <utility>

#include "services/simulator/model/scene_model.hpp"
#include "services/simulator/random.hpp"

namespace markservo::simulator {
namespace {

static_assert(BaseRig::kStep_us == static_cast<std::int64_t>(kTimeStep * 1e6), "base and world take the same steps");

constexpr std::uint64_t kSonarStream = 0xA1;

RfidReaderParameters reader_parameters(const Settings& settings) {
  RfidReaderParameters parameters;
  parameters.delay = settings.rfid_delay_s;
  parameters.delay_jitter = settings.rfid_delay_jitter_s;
  parameters.missed = settings.rfid_missed;
  parameters.duplicates = settings.rfid_duplicate_rate;
  parameters.unknown_tags = settings.rfid_unknown_rate;
  parameters.false_reads = settings.rfid_false_rate;
  parameters.read_time_known = settings.rfid_read_time_known != 0.0;
  return parameters;
}

BaseRigParameters rig_parameters(const Scene& scene, const Settings& settings) {
  BaseRigParameters parameters;
  parameters.base.scale_sigma = settings.base_scale_sigma;
  parameters.base.drift = geometry::radians(settings.base_drift_deg_per_sqrt_m);
  parameters.base.slip = settings.base_slip;
  parameters.floor.missing = settings.rfid_missing_tags;
  parameters.floor.survey_error = settings.rfid_survey_error;
  parameters.reader = reader_parameters(settings);
  parameters.tag_field = scene.dock.field;
  return parameters;
}

SonarParameters sonar_parameters(const Settings& settings) {
  return {settings.sonar_noise, settings.sonar_dropout};
}

}  // namespace

MobileBase::MobileBase(const robot::RobotDescription& robot, const Scene& scene, const Settings& settings,
                       std::uint64_t seed, std::int64_t epoch)
    : rig_(robot, rig_parameters(scene, settings),
           geometry::pose_from_degrees(settings.base_start_x, settings.base_start_y, settings.base_start_heading_deg),
           seed, epoch),
      sonar_parameters_(sonar_parameters(settings)),
      next_scan_(epoch) {
  if (robot.sonars) sonars_.emplace(*robot.sonars, seed_for(seed, kSonarStream, 0));
}

void MobileBase::change(const Settings& settings) {
  rig_.change_reader(reader_parameters(settings));
  sonar_parameters_ = sonar_parameters(settings);
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
