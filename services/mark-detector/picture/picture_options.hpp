#pragma once

// mark-detector --image PICTURE: what the detector finds in a picture, without a bus.

#include <string>

#include "services/mark-detector/mark_detector.hpp"

namespace CLI {
class App;
}

namespace markservo::mark_detector {

class PictureOptions {
 public:
  void add_to(CLI::App& app);

  bool wanted() const { return !image_file_.empty(); }

  // Throws ConfigurationError if the options do not go together.
  void check() const;

  // Looks at the picture, prints JSON and writes the files that are asked for. `equalised`: as the detector does.
  // Throws ConfigurationError.
  void run(const MarkDetector& detector, bool equalised) const;

 private:
  std::string image_file_;
  std::string right_file_;
  std::string annotated_file_;
  std::string mask_folder_;
  bool all_blobs_ = false;
};

}  // namespace markservo::mark_detector
