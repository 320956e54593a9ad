#include "services/recorder/logger/logger_words.hpp"

#include <algorithm>
#include <array>

namespace markservo::recorder {
namespace {

// Of a line without an end.
constexpr std::size_t kLongestLine = 4096;

constexpr std::array<std::string_view, 3> kWorthless = {"Summary: ", "Opening log file", "Logger exiting"};

bool is_worth_keeping(std::string_view line) {
  return !line.empty() && std::none_of(kWorthless.begin(), kWorthless.end(), [line](std::string_view beginning) {
    return line.substr(0, beginning.size()) == beginning;
  });
}

bool has(const std::string& text, const char* words) {
  return text.find(words) != std::string::npos;
}

void append(std::string* text, std::string_view more, std::size_t most) {
  text->append(more.substr(0, most - std::min(most, text->size())));
}

}  // namespace

std::string WordFilter::lines_of(std::string_view text) {
  std::string kept;
  unfinished_ += text;
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = unfinished_.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const std::string_view line(unfinished_.data() + begin, end - begin);
    if (is_worth_keeping(line)) kept.append(line).append("\n");
  }
  unfinished_.erase(0, begin);
  if (unfinished_.size() > kLongestLine) kept += rest();
  return kept;
}

std::string WordFilter::rest() {
  std::string kept = is_worth_keeping(unfinished_) ? unfinished_ + "\n" : std::string();
  unfinished_.clear();
  return kept;
}

void LoggerWords::add(std::string_view text) {
  append(&run_, text, kMostBytes);
  append(&all_, text, kMostBytes);
}

bool LoggerWords::says_self_test_failed() const {
  return has(run_, "self test failed");
}

bool LoggerWords::says_no_route() const {
  return has(run_, "multicast route") || says_self_test_failed();
}

bool LoggerWords::says_disk_was_slow() const {
  return has(all_, "write to log fast enough");
}

bool LoggerWords::says_disk_is_full() const {
  return has(all_, "No space left");
}

std::string LoggerWords::first_line() const {
  const std::size_t begin = run_.find_first_not_of('\n');
  return begin == std::string::npos ? "nothing" : run_.substr(begin, run_.find('\n', begin) - begin);
}

std::string LoggerWords::all() const {
  return all_.substr(0, all_.find_last_not_of('\n') + 1);
}

}  // namespace markservo::recorder
