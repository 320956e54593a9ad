#include "services/stack-watch/supervisor/supervisor_words.hpp"

#include <cstdlib>
#include <cstring>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "common/census/census.hpp"

namespace markservo::stack_watch {
namespace {

constexpr std::int64_t kSecond_us = 1'000'000;

// What stands between `begin` and `end` from `at` on, which then moves behind it; throws where that is not there.
std::string between(std::string_view text, const std::string& begin, const std::string& end, std::size_t* at) {
  const std::size_t from = text.find(begin, *at);
  if (from == std::string_view::npos) throw std::invalid_argument("supervisord's answer ends too soon");
  const std::size_t to = text.find(end, from + begin.size());
  if (to == std::string_view::npos) throw std::invalid_argument("supervisord's answer ends too soon");
  *at = to + end.size();
  return std::string(text.substr(from + begin.size(), to - from - begin.size()));
}

// A text as it was before it was put into XML.
std::string text_of(std::string content) {
  for (const auto& [escape, character] : {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}) {
    for (std::size_t at = content.find(escape); at != std::string::npos; at = content.find(escape, at + 1)) {
      content.replace(at, std::strlen(escape), character);
    }
  }
  return content;
}

// Without the one element around it: "<int>7</int>" is "7", "<string></string>" is "".
std::string content_of(const std::string& value) {
  const std::size_t begin = value.find('>');
  const std::size_t end = value.rfind('<');
  if (begin == std::string::npos || end == std::string::npos || end <= begin) return {};
  return value.substr(begin + 1, end - begin - 1);
}

}  // namespace

bool runs(const SupervisedProcess& process) {
  return process.pid > 0 && process.name != census::kStackWatch &&
         (process.state == "RUNNING" || process.state == "STARTING");
}

std::vector<SupervisedProcess> processes_in(const std::string& answer) {
  if (answer.find("<methodResponse>") == std::string::npos || answer.find("<fault>") != std::string::npos) {
    throw std::invalid_argument("supervisord's answer is no list of processes");
  }
  std::vector<SupervisedProcess> processes;
  std::size_t at = 0;
  while (answer.find("<struct>", at) != std::string::npos) {
    const std::string fields = between(answer, "<struct>", "</struct>", &at);
    SupervisedProcess process;
    std::size_t place = 0;
    while (fields.find("<member>", place) != std::string::npos) {
      const std::string key = between(fields, "<name>", "</name>", &place);
      const std::string value = content_of(between(fields, "<value>", "</value>", &place));
      if (key == "name") process.name = value;
      if (key == "statename") process.state = value;
      if (key == "pid") process.pid = std::atoi(value.c_str());
      if (key == "start") process.start_utime = kSecond_us * std::atoll(value.c_str());
      if (key == "exitstatus") process.exit_code = std::atoi(value.c_str());
      if (key == "spawnerr") process.spawn_error = text_of(value);
    }
    if (process.name.empty() || process.state.empty()) {
      throw std::invalid_argument("supervisord's answer names no process");
    }
    processes.push_back(std::move(process));
  }
  return processes;
}

}  // namespace markservo::stack_watch
