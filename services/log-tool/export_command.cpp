#include "services/log-tool/export_command.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <map>
#include <opencv2/imgcodecs.hpp>
#include <set>

#include "common/logs/log_files.hpp"
#include "services/log-tool/csv_table.hpp"
#include "services/log-tool/frame_pictures.hpp"
#include "services/log-tool/known_values.hpp"

namespace markservo::log_tool {
namespace {

namespace fs = std::filesystem;
using reflection::DecodedMessage;
using reflection::TypeCatalog;

// A name of its own for each channel: neither another folder nor a hidden file, whatever the channel is called, and no
// longer than a file's name may be.
class FileNames {
 public:
  std::string next(const std::string& channel) {
    constexpr std::size_t kLongest = 100;
    std::string name = reflection::printable(channel).substr(0, kLongest);
    std::replace(name.begin(), name.end(), '/', '_');
    if (name.empty() || name[0] == '.') name.insert(0, "_");
    std::string free = name;
    for (int number = 2; !used_.insert(free).second; ++number) free = fmt::format("{}.{}", name, number);
    return free;
  }

 private:
  std::set<std::string> used_;
};

DecodedMessage decoded(const logs::LogEvent& event, const TypeCatalog& types) {
  return reflection::decode(types, event.data.data, event.data.size);
}

std::uint64_t fingerprint_of(const logs::LogEvent& event) {
  std::uint64_t fingerprint = 0;
  reflection::read_fingerprint(event.data.data, event.data.size, &fingerprint);
  return fingerprint;
}

// The first known type among them; null when there is none.
const reflection::MessageType* type_of(const std::vector<logs::LogEvent>& messages, const TypeCatalog& types) {
  for (const logs::LogEvent& message : messages) {
    const reflection::MessageType* type = types.find(fingerprint_of(message));
    if (type != nullptr) return type;
  }
  return nullptr;
}

std::string write_table(const std::string& path, const std::vector<logs::LogEvent>& events, const TypeCatalog& types) {
  CsvColumns columns;
  for (const logs::LogEvent& event : events) columns.learn(reflection::leaves(decoded(event, types).fields));
  std::ofstream table(path);
  table << columns.header();
  std::size_t left_out = 0;
  for (const logs::LogEvent& event : events) {
    DecodedMessage message = decoded(event, types);
    if (message.error.empty()) {
      leave_out_unknown(message.fields);
      table << columns.row(event.utime, reflection::leaves(message.fields));
    } else {
      ++left_out;
    }
  }
  table.flush();
  if (!table) throw logs::LogFileError(path + ": cannot be written; allowed: a folder with room that can be written");
  return fmt::format("{}: {} messages{}\n", path, events.size() - left_out,
                     left_out > 0 ? fmt::format(", {} left out: they cannot be decoded", left_out) : "");
}

std::string write_pictures(const std::string& folder, const std::vector<logs::LogEvent>& events,
                           const TypeCatalog& types) {
  fs::create_directories(folder);
  int number = 0;
  int left_out = 0;
  for (const logs::LogEvent& event : events) {
    ++number;
    const DecodedMessage message = decoded(event, types);
    const FramePictures pictures =
        message.error.empty() ? pictures_of(message.fields) : FramePictures{message.error, {}, {}};
    if (!pictures.error.empty()) {
      ++left_out;
      continue;
    }
    for (const auto& [side, picture] : {std::pair("left", &pictures.left), std::pair("right", &pictures.right)}) {
      const std::string path = fmt::format("{}/{:06}_{}.png", folder, number, side);
      if (!cv::imwrite(path, *picture)) {
        throw logs::LogFileError(path + ": cannot be written; allowed: a folder with room that can be written");
      }
    }
  }
  return fmt::format("{}: {} pairs of images{}\n", folder, number - left_out,
                     left_out > 0 ? fmt::format(", {} left out: they are no images", left_out) : "");
}

}  // namespace

std::string export_events(const std::vector<logs::LogEvent>& events, const std::string& folder,
                          const TypeCatalog& types) {
  std::map<std::string, std::vector<logs::LogEvent>> channels;
  for (const logs::LogEvent& event : events) channels[std::string(event.channel)].push_back(event);
  std::string report;
  FileNames names;
  try {
    fs::create_directories(folder);
    if (!fs::is_empty(folder)) throw logs::LogFileError(folder + ": is not empty; allowed: a new or empty folder");
    for (const auto& [channel, messages] : channels) {
      const reflection::MessageType* type = type_of(messages, types);
      if (type == nullptr) {
        report += fmt::format("{}: left out, {} messages of unknown type {} (--types FILE.lcm... tells it)\n",
                              reflection::printable(channel), messages.size(),
                              reflection::fingerprint_text(fingerprint_of(messages.front())));
        continue;
      }
      const std::string path = folder + "/" + names.next(channel);
      report += write_table(path + ".csv", messages, types);
      if (type->full_name() == "markservo.StereoFrame") report += write_pictures(path, messages, types);
    }
  } catch (const fs::filesystem_error& error) {
    throw logs::LogFileError(folder + ": " + error.code().message() + "; allowed: a folder that can be written");
  }
  return report;
}

}  // namespace markservo::log_tool
