#include "services/stereo-camera/calibration/calibration_tree.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <opencv2/core.hpp>

#include "common/robot/configuration_error.hpp"
#include "common/robot/repeated_keys.hpp"
#include "common/text/text.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr const char* kAllowed =
    "a calibration file of OpenCV (YAML, XML or JSON), or a pair of ROS's camera_info files";

bool begins_with(const std::string& text, const std::string& start) {
  return text.compare(0, start.size(), start) == 0;
}

// Not a folder, whose reading throws, nor a device, which may not end.
bool can_be_read(const std::string& path) {
  std::error_code failed;
  const std::filesystem::file_status status = std::filesystem::status(path, failed);
  return std::filesystem::is_regular_file(status) || std::filesystem::is_fifo(status);
}

std::string read_text(const std::string& path) {
  if (!can_be_read(path)) throw ConfigurationError(fmt::format("{}: is not a file; allowed: {}", path, kAllowed));
  std::ifstream file(path, std::ios::binary);
  std::string text((std::istreambuf_iterator<char>(file)), std::istreambuf_iterator<char>());
  if (begins_with(text, "\xEF\xBB\xBF")) text.erase(0, 3);  // the mark that Windows' editors put before UTF-8
  if (!file || text.find_first_not_of(" \t\r\n") == std::string::npos) {
    throw ConfigurationError(fmt::format("{}: cannot be read or is empty; allowed: {}", path, kAllowed));
  }
  return text;
}

YAML::Node from_opencv(const cv::FileNode& node) {
  YAML::Node tree;
  if (node.isMap()) {
    for (const cv::FileNode& child : node) tree[child.name()] = from_opencv(child);
  } else if (node.isSeq()) {
    for (const cv::FileNode& child : node) tree.push_back(from_opencv(child));
  } else if (node.isInt()) {
    tree = static_cast<int>(node);
  } else if (node.isReal()) {
    tree = static_cast<double>(node);
  } else if (node.isString()) {
    tree = static_cast<std::string>(node);
  }
  return tree;
}

// What OpenCV's parser is not to be given: it reads past the end of a text that ends within an element, and may crash.
void require_whole_xml(const std::string& path, const std::string& text) {
  const auto refuse = [&path](std::ptrdiff_t line, const char* what) {
    throw ConfigurationError(fmt::format("{}: line {}: {}; allowed: well-formed XML of OpenCV", path, line, what));
  };
  if (text.find("<?xml") != text.find_first_not_of(" \t\r\n")) refuse(1, "begins without <?xml");
  if (text.find("</opencv_storage>") != std::string::npos) return;
  refuse(1 + std::count(text.begin(), text.end(), '\n'), "ends without </opencv_storage>");
}

// The "FILE(12): what is wrong" of OpenCV's words, as line and words.
std::string where_and_what(const std::string& words) {
  const std::size_t close = words.rfind("): ");
  const std::size_t open = words.rfind('(', close);
  const bool placed = close != std::string::npos && open != std::string::npos && close > open + 1 &&
                      words.find_first_not_of("0123456789", open + 1) == close;
  if (!placed) return "cannot be parsed";
  const std::size_t end = words.find_first_of("'\n", close);
  return "line " + words.substr(open + 1, close - open - 1) + words.substr(close + 1, end - close - 1);
}

YAML::Node parse_xml(const std::string& path, const std::string& text) {
  require_whole_xml(path, text);
  try {
    const cv::FileStorage storage(text, cv::FileStorage::READ | cv::FileStorage::MEMORY);
    return from_opencv(storage.root());
  } catch (const cv::Exception& error) {
    throw ConfigurationError(
        fmt::format("{}: {}; allowed: well-formed XML", path, text::printable(where_and_what(error.what()))));
  }
}

YAML::Node parse_yaml(const std::string& path, std::string text) {
  // YAML knows no such directive; the empty line keeps the others' numbers.
  if (begins_with(text, "%YAML:")) text.erase(0, text.find_first_of("\r\n"));
  try {
    return YAML::Load(text);
  } catch (const YAML::Exception& error) {
    throw ConfigurationError(fmt::format("{}: line {}: {}; allowed: well-formed YAML", path, error.mark.line + 1,
                                         text::printable(error.msg)));
  }
}

}  // namespace

YAML::Node load_calibration_tree(const std::string& path) {
  const std::string text = read_text(path);
  const bool xml = text[text.find_first_not_of(" \t\r\n")] == '<';
  YAML::Node root = xml ? parse_xml(path, text) : parse_yaml(path, text);
  if (!root.IsMap() || root.size() == 0) {
    throw ConfigurationError(fmt::format("{}: has no keys; allowed: {}", path, kAllowed));
  }
  robot::refuse_repeated_keys(path, root);
  return root;
}

}  // namespace markservo::stereo_camera
