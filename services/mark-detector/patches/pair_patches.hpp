#pragma once

// The patches of all marks of a pair.

#include <cstddef>
#include <vector>

#include "services/mark-detector/detector_input.hpp"
#include "services/mark-detector/detector_output.hpp"
#include "services/mark-detector/patches/patch_cutter.hpp"
#include "services/mark-detector/patches/patch_plan.hpp"

namespace markservo::mark_detector {

// Keeps its memory from pair to pair.
class PairPatches {
 public:
  // Gives each mark that both images see its patches, as far as the budget reaches, and all others none. What the arm
  // works on is served first: the hand, then targets from the one next to the hand outwards; without a hand, from the
  // middle of the image outwards.
  void cut(const Input& input, const PatchParameters& parameters, std::vector<Finding>& findings);

 private:
  std::vector<std::size_t> order_;  // of the findings, by importance
  std::vector<PatchRequest> requests_;
  PatchPlan plan_;
  PatchCutter cutter_;
};

}  // namespace markservo::mark_detector
