#include "services/recorder/folder/part_names.hpp"

#include <spdlog/fmt/fmt.h>

#include <algorithm>
#include <charconv>
#include <set>

namespace markservo::recorder {
namespace {

constexpr std::int64_t kNoNumber = -1;

std::string numbered(std::int64_t number) {
  return fmt::format("{}.{:02}", kLogName, number);
}

}  // namespace

std::optional<std::int64_t> part_number(const std::string& name) {
  const std::string stem = kLogName;
  if (name == stem) return kNoNumber;
  if (name.rfind(stem + ".", 0) != 0) return std::nullopt;
  const char* begin = name.data() + stem.size() + 1;
  const char* end = name.data() + name.size();
  std::int64_t number = 0;
  const auto [read, error] = std::from_chars(begin, end, number);
  if (error != std::errc() || read != end || *begin == '-') return std::nullopt;
  return number;
}

std::vector<Part> parts_in_order(std::vector<Part> files) {
  files.erase(std::remove_if(files.begin(), files.end(), [](const Part& file) { return !part_number(file.name); }),
              files.end());
  std::sort(files.begin(), files.end(),
            [](const Part& a, const Part& b) { return part_number(a.name) < part_number(b.name); });
  return files;
}

std::vector<std::string> parts_to_remove(const std::vector<Part>& parts, std::size_t keep) {
  std::vector<std::string> old;
  for (std::size_t i = 0; i + keep < parts.size(); ++i) old.push_back(parts[i].name);
  return old;
}

NextPart next_part(const std::vector<Part>& parts, bool split, int runs) {
  if (!split) return {runs == 0 ? kLogName : numbered(runs), {}};
  NextPart next{kLogName, {}};
  if (parts.empty()) return next;
  std::set<std::string> there;
  for (const Part& part : parts) there.insert(part.name);
  const std::int64_t last = part_number(parts.back().name).value_or(kNoNumber);
  for (std::int64_t number = 0; number <= last; ++number) {
    if (there.count(numbered(number)) == 0) next.places_to_hold.push_back(numbered(number));
  }
  return next;
}

std::vector<std::string> held_places(const std::vector<Part>& parts) {
  std::vector<std::string> places;
  for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
    if (parts[i].bytes == 0 && parts[i].name != kLogName) places.push_back(parts[i].name);
  }
  return places;
}

}  // namespace markservo::recorder
