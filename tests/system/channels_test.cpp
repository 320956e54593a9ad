// The table of channels, what the services truly read and write, and what the pages say of it are one.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <markservo/channels.hpp>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "tests/unit/command.hpp"

namespace markservo {
namespace {

using Names = std::set<std::string>;

struct Tested {
  std::string name;
  std::string options;
};

const std::vector<Tested>& services() {
  static const std::string picture = MARKSERVO_SOURCE_DIR "/.github/demo.png";
  // Of those that do not start without one.
  static const std::map<std::string, std::string> options = {
      {"stereo-camera", " --left " + picture + " --right " + picture + " --fx 600 --baseline 0.06"},
      {"task-operator", " stop"},
      {"mmi", " --enable-commands --command-token-file '" MARKSERVO_BIN_DIR "/channels_test.token'"},
  };
  static const std::vector<Tested> all = [] {
    std::vector<Tested> asked;
    std::istringstream names(MARKSERVO_ASKED_SERVICES);
    for (std::string name; names >> name;) {
      const auto own = options.find(name);
      asked.push_back({name, own == options.end() ? "" : own->second});
    }
    return asked;
  }();
  return all;
}

// Who reads all of a bus, and who is no service.
bool is_no_single_service(const std::string& name) {
  static const Names names = {"all", "person", "bus-census", "bus-top", "recorder", "stack-watch"};
  return names.count(name) > 0;
}

Names by_the_table(const std::string& service, const char* channels::Entry::*list) {
  Names names;
  for (const channels::Entry& entry : channels::kAll) {
    if (channels::has(entry.*list, service) || channels::has(entry.*list, "all")) names.insert(entry.name);
  }
  return names;
}

Names lines_after(const std::string& word, const std::string& text) {
  Names names;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind(word + " ", 0) == 0) names.insert(line.substr(word.size() + 1));
  }
  return names;
}

std::string text_of(const std::string& file) {
  std::ostringstream text;
  text << std::ifstream(MARKSERVO_SOURCE_DIR "/" + file).rdbuf();
  return text.str();
}

// The channels of the table that a text names.
Names channels_in(const std::string& text) {
  Names names;
  std::string word;
  for (const char c : text + " ") {
    const bool part = (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    if (part) word += c;
    if (part) continue;
    if (channels::find(word) != nullptr) names.insert(word);
    word.clear();
  }
  return names;
}

// The cells of the row of services/README.md that begins with `first`; empty: there is none.
std::vector<std::string> row_of(const std::string& first) {
  std::istringstream lines(text_of("services/README.md"));
  for (std::string line; std::getline(lines, line);) {
    if (line.rfind("| " + first + " |", 0) != 0) continue;
    std::vector<std::string> cells;
    std::istringstream row(line.substr(1));
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
    return cells;
  }
  return {};
}

TEST(TableOfChannels, SaysWhatEachServiceTrulyReadsAndWrites) {
  for (const Tested& service : services()) {
    const test::CommandResult result = test::run_command("cd '" MARKSERVO_SOURCE_DIR "' && '" MARKSERVO_BIN_DIR "/" +
                                                         service.name + "' --list-channels" + service.options);
    ASSERT_EQ(result.exit_code, 0) << service.name << ": " << result.output;
    EXPECT_EQ(lines_after("reads", result.output), by_the_table(service.name, &channels::Entry::readers))
        << service.name;
    EXPECT_EQ(lines_after("writes", result.output), by_the_table(service.name, &channels::Entry::writers))
        << service.name;
  }
}

TEST(TableOfChannels, NamesNoServiceThatThisTestDoesNotAsk) {
  Names known;
  for (const Tested& service : services()) known.insert(service.name);
  known.insert({"simulator", "mmi"});  // not built everywhere
  for (const channels::Entry& entry : channels::kAll) {
    for (const char* list : {entry.writers, entry.readers}) {
      std::istringstream names(list);
      for (std::string name; names >> name;) {
        EXPECT_TRUE(known.count(name) > 0 || is_no_single_service(name))
            << entry.name << " names " << name << ": add it to asked_services in tests/system/CMakeLists.txt";
      }
    }
  }
}

TEST(ServicesPage, HasTheTablesChannelsInEachServicesRow) {
  std::vector<Tested> all = services();
  if (all.back().name != "simulator") all.push_back({"simulator", ""});
  for (const Tested& service : all) {
    const std::vector<std::string> cells = row_of(service.name);
    ASSERT_GE(cells.size(), 3U) << service.name << " has no row in services/README.md";
    EXPECT_EQ(channels_in(cells[1]), by_the_table(service.name, &channels::Entry::readers)) << service.name;
    Names writes = by_the_table(service.name, &channels::Entry::writers);
    writes.erase(channels::kServiceStatus.name);  // said of all, below the rows
    EXPECT_EQ(channels_in(cells[2]), writes) << service.name;
  }
}

std::string second_text(channels::Second second) {
  switch (second) {
    case channels::Second::kAllowed:
      return "many write";
    case channels::Second::kIgnored:
      return "is named";
    case channels::Second::kHold:
      return "makes all hold";
  }
  return "";
}

TEST(ChannelsPage, HasARowForEachChannelAndNoOther) {
  const std::string page = text_of("lcmtypes/README.md");
  for (const channels::Entry& entry : channels::kAll) {
    const std::string type = entry.type;
    const std::string moves = entry.moves_robot ? "moves" : entry.feeds_motion ? "feeds" : "";
    const std::string row = fmt::format("| {} | [{}]({}.lcm) | {} | {} | {} |\n", entry.name, type, type, entry.what,
                                        second_text(entry.second), moves);
    EXPECT_NE(page.find(row), std::string::npos) << "lacks the row\n" << row;
  }
  const auto rows = std::count(page.begin(), page.end(), '\n');
  std::istringstream lines(page);
  std::size_t channel_rows = 0;
  for (std::string line; std::getline(lines, line);) channel_rows += line.find(".lcm) |") != std::string::npos ? 1 : 0;
  EXPECT_EQ(channel_rows, channels::kAll.size()) << "of " << rows << " lines";
}

}  // namespace
}  // namespace markservo
