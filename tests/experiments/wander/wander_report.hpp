#pragma once

// What the runs of the wander experiment say together.

#include <cstdint>
#include <string>
#include <vector>

#include "services/rfid-localizer/wheel_report.hpp"
#include "services/simulator/base/base_model.hpp"
#include "tests/experiments/localisation/verdict.hpp"
#include "tests/experiments/wander/wander_run.hpp"

namespace markservo::experiments {

enum class WanderCase {
  kDelivered,       // worse wheels, robot.yaml as it is
  kProposed,        // worse wheels, robot.yaml with the numbers that the service proposed after the drive
  kStated,          // wheels as robot.yaml states
  kStatedUnjudged,  // the same drive, the localizer as it was before it judged its wheels
};

const char* name_of(WanderCase the_case);

struct WanderResult {
  WanderCase the_case = WanderCase::kDelivered;
  std::int64_t seed = 0;
  double driven = 0.0;  // m, by a wheel on average
  double turned = 0.0;  // rad, both directions added up
  double bound = 0.0;   // m
  WanderScore score;
};

// What the service proposed after the drive; nothing where it did not judge.
rfid_localizer::WheelProposal proposal_of(const WanderResult& result);

// `truth`: how the worse wheels err.
std::vector<Verdict> wander_verdicts(const std::vector<WanderResult>& results,
                                     const simulator::BaseModelParameters& truth);
void print_wander(const std::vector<WanderResult>& results);
// wander.json in `folder`: an entry per run, totals, bars.
void write_wander_json(const std::vector<WanderResult>& results, const std::vector<Verdict>& verdicts,
                       const std::string& folder);

}  // namespace markservo::experiments
