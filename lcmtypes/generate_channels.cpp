// Writes markservo/channels.hpp from the table of channels. A part of the build.
//
// usage: generate_channels TABLE HEADER TYPE...
// TYPE: the message types that exist. Exits 2 with one line that names file, line, key, value and what is allowed if
// the table is wrong, and leaves HEADER as it was.

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iostream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

using Names = std::vector<std::string>;

struct Line {
  std::string name;
  std::string type;
  std::string initializer;
};

// One channel's keys.
class ChannelNode {
 public:
  ChannelNode(std::string file, std::string name, const YAML::Node& node)
      : file_(std::move(file)), name_(std::move(name)), node_(node) {
    if (!node_.IsMap()) fail("", "no keys", "type, writers, readers, ...");
    for (const auto& pair : node_) {
      const auto key = pair.first.as<std::string>();
      if (!keys_.insert(key).second) fail(key, "given twice", "once");
    }
  }

  std::string one_of(const std::string& key, const Names& choices) {
    const std::string value = text(key);
    if (std::find(choices.begin(), choices.end(), value) == choices.end())
      fail(key, "'" + value + "'", joined(choices));
    return value;
  }

  std::string flag(const std::string& key) { return one_of(key, {"true", "false"}); }

  // Printable ASCII, so that it is a C++ literal too.
  std::string text(const std::string& key) {
    const YAML::Node node = take(key);
    if (!node.IsScalar()) fail(key, "no text", "a text");
    const auto value = node.as<std::string>();
    const bool printable =
        std::all_of(value.begin(), value.end(), [](unsigned char c) { return std::isprint(c) != 0; });
    if (value.empty() || !printable || value.find_first_of("\"\\") != std::string::npos) {
      fail(key, "'" + value + "'", "a text of ASCII without \" and \\");
    }
    return value;
  }

  // One blank between them.
  std::string names(const std::string& key) {
    const YAML::Node node = take(key);
    if (!node.IsSequence()) fail(key, "no list", "a list of services, [] for none");
    std::string all;
    for (const auto& each : node) {
      const auto value = each.IsScalar() ? each.as<std::string>() : std::string();
      const bool plain = std::all_of(value.begin(), value.end(), [](unsigned char c) {
        return std::islower(c) != 0 || std::isdigit(c) != 0 || c == '-';
      });
      if (value.empty() || !plain) fail(key, "'" + value + "'", "a service's name: a to z, 0 to 9 and -");
      all += (all.empty() ? "" : " ") + value;
    }
    return all;
  }

  // What is left over is a misspelt key.
  void require_all_used() const {
    for (const std::string& key : keys_) fail(key, "unknown", "the keys that the file's head explains");
  }

  [[noreturn]] void fail(const std::string& key, const std::string& value, const std::string& allowed) const {
    std::ostringstream words;
    words << file_ << ":" << node_.Mark().line + 1 << ": " << name_ << (key.empty() ? "" : "." + key) << " is " << value
          << "; allowed: " << allowed;
    throw std::invalid_argument(words.str());
  }

 private:
  static std::string joined(const Names& choices) {
    std::string words;
    for (const std::string& choice : choices) words += (words.empty() ? "" : ", ") + choice;
    return words;
  }

  YAML::Node take(const std::string& key) {
    if (keys_.erase(key) == 0) fail(key, "missing", "every key is given");
    return node_[key];
  }

  std::string file_;
  std::string name_;
  YAML::Node node_;
  std::set<std::string> keys_;
};

// "STEREO_FRAME" and "until_echoed" as "kStereoFrame" and "kUntilEchoed".
std::string constant(const std::string& name) {
  std::string words = "k";
  bool begins = true;
  for (const char c : name) {
    if (c != '_') words += static_cast<char>(begins ? std::toupper(c) : std::tolower(c));
    begins = c == '_';
  }
  return words;
}

Line read_channel(const std::string& file, const std::string& name, const YAML::Node& node, const Names& types) {
  ChannelNode channel(file, name, node);
  const bool upper_snake = std::all_of(name.begin(), name.end(), [](unsigned char c) {
    return std::isupper(c) != 0 || std::isdigit(c) != 0 || c == '_';
  });
  if (!upper_snake || std::isupper(static_cast<unsigned char>(name[0])) == 0)
    channel.fail("", "a channel's name", "A to Z, 0 to 9 and _");
  Line line{name, channel.one_of("type", types), ""};
  std::ostringstream words;
  words << "\"" << name << "\", \"" << line.type
        << "\", Second::" << constant(channel.one_of("second", {"allowed", "ignored", "hold"}));
  for (const char* key : {"moves_robot", "feeds_motion", "live"}) words << ", " << channel.flag(key);
  words << ", Repeat::" << constant(channel.one_of("repeat", {"none", "steadily", "until_echoed"}));
  words << ", " << channel.flag("large") << ",\n    \"" << channel.text("what") << "\"";
  for (const char* key : {"writers", "readers"}) words << ", \"" << channel.names(key) << "\"";
  channel.require_all_used();
  line.initializer = words.str();
  return line;
}

std::vector<Line> read_table(const std::string& file, const Names& types) {
  const YAML::Node table = YAML::LoadFile(file);
  if (!table.IsMap()) throw std::invalid_argument(file + ": holds no channels; allowed: NAME: {type: ..., ...}");
  std::vector<Line> lines;
  std::set<std::string> constants;
  for (const auto& pair : table) {
    const auto name = pair.first.as<std::string>();
    lines.push_back(read_channel(file, name, pair.second, types));
    if (!constants.insert(constant(name)).second)
      throw std::invalid_argument(file + ": " + name + " is given twice; allowed: once");
  }
  return lines;
}

std::string header_of(const std::vector<Line>& lines) {
  std::ostringstream out;
  out << "#pragma once\n\n// The channels of the bus. Made from lcmtypes/channels.yaml by generate_channels.\n\n"
      << "#include <array>\n#include <string_view>\n\n#include \"lcmtypes/channel.hpp\"\n\nnamespace markservo {\n\n";
  std::set<std::string> types;
  for (const Line& line : lines) types.insert(line.type);
  for (const std::string& type : types) out << "class " << type << ";\n";
  out << "\n}  // namespace markservo\n\nnamespace markservo::channels {\n\n";
  for (const Line& line : lines) {
    out << "inline constexpr Channel<" << line.type << "> " << constant(line.name) << "{Entry{\n    "
        << line.initializer << "}};\n";
  }
  out << "\ninline constexpr std::array<Entry, " << lines.size() << "> kAll{{\n";
  for (const Line& line : lines) out << "    " << constant(line.name) << ",\n";
  out << "}};\n\n// Null for a name that is not in the table. A robot's prefix is no part of a name.\n"
      << "constexpr const Entry* find(std::string_view name) {\n  for (const Entry& entry : kAll) {\n"
      << "    if (name == entry.name) return &entry;\n  }\n  return nullptr;\n}\n\n"
      << "}  // namespace markservo::channels\n";
  return out.str();
}

void write_if_new(const std::string& path, const std::string& text) {
  std::ostringstream old;
  old << std::ifstream(path).rdbuf();
  if (old.str() == text) return;
  std::ofstream out(path);
  out << text;
  out.close();
  if (!out) throw std::runtime_error(path + ": cannot be written");
}

}  // namespace

int main(int argc, char** argv) {
  const Names arguments(argv + 1, argv + argc);
  if (arguments.size() < 3) {
    std::cerr << "usage: generate_channels TABLE HEADER TYPE...\n";
    return 2;
  }
  try {
    write_if_new(arguments[1], header_of(read_table(arguments[0], {arguments.begin() + 2, arguments.end()})));
  } catch (const YAML::Exception& error) {
    std::cerr << arguments[0] << ": " << error.what() << "\n";
    return 2;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 2;
  }
  return 0;
}
