#pragma once

// Which picture files a pattern stands for, and which of two lists belong together.

#include <string>
#include <utility>
#include <vector>

namespace markservo::stereo_camera {

// A file and its number in the sequence.
struct NumberedPicture {
  long number = 0;
  std::string path;
};

// The existing files that `pattern` stands for, by rising number; gaps are allowed. The pattern's file name has one %d
// or %0Nd (N from 1 to 9); without one it is a single file with number 0. Throws ConfigurationError where the pattern
// is malformed or no file matches; `option` names the setting in the message.
std::vector<NumberedPicture> expand_pattern(const std::string& pattern, const std::string& option);

struct PairedPictures {
  std::vector<std::string> left;
  std::vector<std::string> right;
  std::string note;  // which pictures have no partner; empty when all have
};

// The pictures whose numbers both lists have, in order. Throws ConfigurationError where there is none.
PairedPictures pair_by_number(const std::vector<NumberedPicture>& left, const std::vector<NumberedPicture>& right);

// Whether the name is a picture's or a pattern's; anything else is taken as a video.
bool is_picture_name(const std::string& name);

}  // namespace markservo::stereo_camera
