#pragma once

// The detector on a sequence of frames under changing light, scored by where the marks are.

#include <string>
#include <vector>

#include "services/mark-detector/mark_detector.hpp"
#include "tests/light/light_scene.hpp"
#include "tests/light/light_sequences.hpp"

namespace markservo::light {

struct MarkScore {
  std::string mark;
  int visible = 0;                  // frames in which it could be seen
  int found = 0;                    // of them, those in which both images saw it where it is
  int longest_lost = 0;             // frames in a row in which it could be seen and was not found
  int wrong = 0;                    // frames in which something else was taken for it
  int confused = 0;                 // of them, those in which it was another mark
  int hidden = 0;                   // frames in which it was hidden
  double least_separability = 1.0;  // where found
};

struct Trial {
  std::vector<MarkScore> marks;
};

// Runs a new detector over the sequence.
Trial run_trial(LightScene& scene, const std::vector<LightFrame>& sequence,
                const std::vector<robot::MarkDescription>& marks, const mark_detector::Parameters& parameters);

}  // namespace markservo::light
