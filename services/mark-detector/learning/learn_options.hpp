#pragma once

// mark-detector --learn NAME --box x,y,w,h IMAGE...: writes a mark's colour, as pictures show it, into the robot's
// file.

#include <string>
#include <vector>

#include "services/mark-detector/learning/colour_learning.hpp"

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

  // Measures, writes the file, prints the old and the new interval, and warns on the standard error of marks that are
  // no longer told apart. Throws ConfigurationError, and the file is as it was.
  void run(const std::string& robot_file, const LearningParameters& parameters) const;

 private:
  std::string mark_;
  std::vector<std::string> boxes_;
  std::vector<std::string> images_;
};

}  // namespace markservo::mark_detector
