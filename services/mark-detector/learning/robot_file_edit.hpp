#pragma once

// Changes a mark's colour in a robot.yaml or its text and nothing else: comments, order and layout stay.

#include <string>

#include "common/robot/robot_description.hpp"

namespace markservo::mark_detector {

// The text with the six numbers of the mark's colour replaced; `path` is only named in errors. Throws
// ConfigurationError if the text has no such mark or another mark would change too (an alias).
std::string with_colour(const std::string& text, const std::string& path, const std::string& mark,
                        const robot::ColourInterval& colour);

// Does so in the file at `path`, at once: a reader sees the old or the new. Throws ConfigurationError as with_colour(),
// or if the file cannot be read or written, and leaves it as it was.
void write_colour(const std::string& path, const std::string& mark, const robot::ColourInterval& colour);

// An interval as robot.yaml has it: hue_deg: [345, 15], saturation: [0.5, 1], value: [0.2, 1].
std::string to_text(const robot::ColourInterval& colour);

}  // namespace markservo::mark_detector
