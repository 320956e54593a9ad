#pragma once

// mark-detector --learn NAME --box x,y,w,h IMAGE...: writes a mark's colour, as pictures show it, into the robot's
// file.

#include <string>
#include <vector>

#include "services/mark-detector/learning/colour_learning.hpp"
#include "services/mark-detector/learning/mark_learning.hpp"
#include "services/mark-detector/mark_detector.hpp"

namespace CLI {
class App;
}

namespace markservo::mark_detector {

class LearnOptions {
 public:
  void add_to(CLI::App& app);

  bool wanted() const { return !mark_.empty(); }

  // Throws ConfigurationError if the options do not go together.
  void check() const;

  // Measures, writes the file, prints the old and the new interval, and lets the detector look for the mark in the
  // pictures with it. Warns on the standard error of pictures where it does not find the mark as boxed, and of marks
  // that are no longer told apart. Throws ConfigurationError, or std::invalid_argument for the detector's parameters,
  // and the file is as it was.
  void run(const std::string& robot_file, const LearningParameters& learning, const Parameters& detection) const;

 private:
  void warn(const MarkLearning& learned) const;

  std::string mark_;
  std::vector<std::string> boxes_;
  std::vector<std::string> images_;
};

}  // namespace markservo::mark_detector
