#pragma once

// The files that calibration tools write, as one kind of tree.

#include <yaml-cpp/yaml.h>

#include <string>

namespace markservo::stereo_camera {

// Reads YAML, with OpenCV's own first line (%YAML:1.0) or without, JSON, or OpenCV's XML. The root is a map. Throws
// ConfigurationError, which names the line where the syntax is wrong, for a file that is not there, empty, not
// well-formed, or has a key twice.
YAML::Node load_calibration_tree(const std::string& path);

}  // namespace markservo::stereo_camera
