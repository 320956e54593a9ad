// scripts/experiment wander: wheels that are worse than robot.yaml states, what the localizer makes of them and what it
// says of them. Its core runs in this process: 15 minutes of driving take seconds.

#include "common/robot/configuration_error.hpp"
#include "tests/experiments/experiment.hpp"
#include "tests/experiments/localisation/described_wheels.hpp"
#include "tests/experiments/progress_bar.hpp"
#include "tests/experiments/wander/pivot_drive.hpp"
#include "tests/experiments/wander/wander_report.hpp"
#include "tests/experiments/wander/wander_run.hpp"

namespace markservo::experiments {
namespace {

constexpr char kField[] = "hall";
constexpr double kWorseDrift = geometry::radians(8.0);  // rad per sqrt(m)
constexpr double kWorseWander = 0.02;                   // m per sqrt(rad)

simulator::BaseModelParameters worse_wheels(const robot::BaseDescription& base) {
  simulator::BaseModelParameters wheels = wheels_as_stated(base);
  wheels.drift = kWorseDrift;
  wheels.pivot_wander = kWorseWander;
  return wheels;
}

// Both drives of a seed, localised.
std::vector<WanderResult> run_seed(const robot::RobotDescription& robot, std::int64_t seed) {
  std::vector<WanderResult> results;
  const auto drive_by = [&](const simulator::BaseModelParameters& wheels) {
    simulator::BaseRigParameters rig;
    rig.base = wheels;
    rig.tag_field = kField;
    return drive_with_pivots(robot, rig, PivotDrive{}, static_cast<std::uint64_t>(seed));
  };
  const auto add = [&](WanderCase the_case, const Drive& drive, const robot::RobotDescription& told, double bound) {
    WanderRun run;
    run.tag_field = kField;
    run.judging = the_case != WanderCase::kStatedUnjudged;
    WanderResult result{the_case, seed, drive.truth.back().wheel_travel, drive.truth.back().turned, bound, {}};
    result.score = localise_in_process(drive, told, run);
    results.push_back(result);
  };
  WanderRun scored;
  scored.tag_field = kField;

  const simulator::BaseModelParameters worse = worse_wheels(*robot.base);
  const Drive worse_drive = drive_by(worse);
  const double worse_bound = mean_bound(worse_drive, robot, scored, worse);
  add(WanderCase::kDelivered, worse_drive, robot, worse_bound);
  robot::RobotDescription mended = robot;
  const rfid_localizer::WheelProposal proposal = proposal_of(results.back());
  if (proposal.drift_deg_per_sqrt_m) mended.base->drift = geometry::radians(*proposal.drift_deg_per_sqrt_m);
  if (proposal.pivot_wander) mended.base->pivot_wander = *proposal.pivot_wander;
  add(WanderCase::kProposed, worse_drive, mended, worse_bound);

  const simulator::BaseModelParameters stated = wheels_as_stated(*robot.base);
  const Drive stated_drive = drive_by(stated);
  const double stated_bound = mean_bound(stated_drive, robot, scored, stated);
  add(WanderCase::kStated, stated_drive, robot, stated_bound);
  add(WanderCase::kStatedUnjudged, stated_drive, robot, stated_bound);
  return results;
}

bool experiment(const ExperimentOptions& options) {
  const robot::RobotDescription robot = robot::load_robot_description(options.robot_file);
  if (!robot.base || !robot.rfid || !robot.floor_tags) {
    throw ConfigurationError(options.robot_file + ": lacks base, rfid or floor_tags; the experiment needs all three");
  }
  ProgressBar progress(options.trials);
  std::vector<std::vector<WanderResult>> seeds(static_cast<std::size_t>(options.trials));
  run_in_parallel(seeds.size(), "wander", progress,
                  [&](std::size_t i) { seeds[i] = run_seed(robot, options.seed + static_cast<std::int64_t>(i)); });

  std::vector<WanderResult> results;
  for (const auto& seed : seeds) results.insert(results.end(), seed.begin(), seed.end());
  const std::vector<Verdict> verdicts = wander_verdicts(results, worse_wheels(*robot.base));
  print_wander(results);
  bool met = true;
  for (const Verdict& verdict : verdicts) {
    met = met && verdict.met();
    print_verdict(verdict);
  }
  write_wander_json(results, verdicts, options.out);
  return met;
}

}  // namespace
}  // namespace markservo::experiments

int main(int argc, char** argv) {
  using namespace markservo::experiments;
  return run_experiment("Wheels that are worse than robot.yaml states: what the localizer makes and says of them", 20,
                        argc, argv, experiment);
}
