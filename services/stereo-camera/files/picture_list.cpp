#include "services/stereo-camera/files/picture_list.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <optional>
#include <system_error>

#include "common/robot/configuration_error.hpp"

namespace markservo::stereo_camera {
namespace {

constexpr std::size_t kMaxDigits = 9;  // numbers fit in a long

struct Pattern {
  std::string before;
  std::string after;
  std::size_t digits = 0;  // fewest digits of the number
};

std::optional<Pattern> parse_pattern(const std::string& name) {
  const std::size_t percent = name.find('%');
  if (percent == std::string::npos || name.find('%', percent + 1) != std::string::npos) return std::nullopt;
  const std::size_t d = name.find_first_not_of("0123456789", percent + 1);
  if (d == std::string::npos || name[d] != 'd') return std::nullopt;
  const std::string width = name.substr(percent + 1, d - percent - 1);
  Pattern pattern{name.substr(0, percent), name.substr(d + 1), 1};
  if (width.empty()) return pattern;
  if (width.size() != 2 || width[0] != '0' || width[1] == '0') return std::nullopt;
  pattern.digits = static_cast<std::size_t>(width[1] - '0');
  return pattern;
}

// The number in `name` where it fits the pattern. As printf writes it: zeros in front only up to the width.
std::optional<long> number_in(const std::string& name, const Pattern& pattern) {
  if (name.size() < pattern.before.size() + pattern.after.size() + pattern.digits) return std::nullopt;
  if (name.compare(0, pattern.before.size(), pattern.before) != 0) return std::nullopt;
  if (name.compare(name.size() - pattern.after.size(), std::string::npos, pattern.after) != 0) return std::nullopt;
  const std::string digits =
      name.substr(pattern.before.size(), name.size() - pattern.before.size() - pattern.after.size());
  const bool all_digits =
      std::all_of(digits.begin(), digits.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
  if (!all_digits || digits.size() > kMaxDigits) return std::nullopt;
  if (digits.size() > pattern.digits && digits[0] == '0') return std::nullopt;
  return std::stol(digits);
}

}  // namespace

std::vector<NumberedPicture> expand_pattern(const std::string& pattern_text, const std::string& option) {
  namespace fs = std::filesystem;
  const fs::path path(pattern_text);
  const std::string name = path.filename().string();
  std::error_code error;
  if (name.find('%') == std::string::npos) {
    if (!fs::is_regular_file(path, error)) {
      throw ConfigurationError(option + " is '" + pattern_text +
                               "', which is no file; allowed: a picture, a video, or "
                               "a pattern as left_%02d.png");
    }
    return {{0, pattern_text}};
  }
  const auto pattern = parse_pattern(name);
  if (!pattern) {
    throw ConfigurationError(option + " is '" + pattern_text +
                             "'; allowed: one %d or %0Nd (N from 1 to 9) in the file's "
                             "name");
  }
  std::vector<NumberedPicture> pictures;
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const auto number = number_in(entry->path().filename().string(), *pattern);
    if (number) pictures.push_back({*number, entry->path().string()});
  }
  if (pictures.empty()) {
    throw ConfigurationError(option + " is '" + pattern_text +
                             "', which no file matches; allowed: a pattern of existing "
                             "pictures");
  }
  std::sort(pictures.begin(), pictures.end(),
            [](const NumberedPicture& a, const NumberedPicture& b) { return a.number < b.number; });
  return pictures;
}

PairedPictures pair_by_number(const std::vector<NumberedPicture>& left, const std::vector<NumberedPicture>& right) {
  PairedPictures paired;
  auto l = left.begin();
  auto r = right.begin();
  while (l != left.end() && r != right.end()) {
    if (l->number == r->number) {
      paired.left.push_back((l++)->path);
      paired.right.push_back((r++)->path);
    } else if (l->number < r->number) {
      ++l;
    } else {
      ++r;
    }
  }
  if (paired.left.empty()) {
    throw ConfigurationError("--left has number " + std::to_string(left.front().number) + " to " +
                             std::to_string(left.back().number) + ", --right " + std::to_string(right.front().number) +
                             " to " + std::to_string(right.back().number) +
                             "; allowed: pictures with the same numbers");
  }
  if (paired.left.size() != left.size() || paired.right.size() != right.size()) {
    paired.note = "left has " + std::to_string(left.size()) + " pictures, right has " + std::to_string(right.size()) +
                  "; only the " + std::to_string(paired.left.size()) + " with a partner are used";
  }
  return paired;
}

bool is_picture_name(const std::string& name) {
  const std::string file_name = std::filesystem::path(name).filename().string();
  if (file_name.find('%') != std::string::npos) return true;
  std::string extension = std::filesystem::path(name).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  static constexpr std::array kPictures{".png", ".jpg", ".jpeg", ".bmp",  ".ppm",
                                        ".pgm", ".pnm", ".tif",  ".tiff", ".webp"};
  return std::find(kPictures.begin(), kPictures.end(), extension) != kPictures.end();
}

}  // namespace markservo::stereo_camera
