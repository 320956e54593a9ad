#pragma once

#include <string>

namespace markservo::mark_detector {

// The whole content of the file at `path`. Throws ConfigurationError if it cannot be read.
std::string read_file(const std::string& path);

// Gives a file new content at once: a reader sees the old or the new, and a failure leaves the old. Permissions stay; a
// link stays one, and the file it leads to is replaced. Throws ConfigurationError if it cannot be written.
void replace_file(const std::string& path, const std::string& content);

}  // namespace markservo::mark_detector
