#include "services/recorder/terminal.hpp"

#include <unistd.h>

#include <cstdio>

#include "common/text/text.hpp"

namespace markservo::recorder {
namespace {

constexpr const char* kClear = "\r\033[K";

void print(std::FILE* stream, const std::string& text) {
  std::fwrite(text.data(), 1, text.size(), stream);
  std::fflush(stream);  // a file may be read by whoever waits for it
}

}  // namespace

void say(const std::string& text) {
  print(stdout, text + "\n");
}

void warn(const std::string& text) {
  print(stderr, "record: " + text::printable(text) + "\n");
}

bool is_terminal() {
  return isatty(STDOUT_FILENO) != 0;
}

void show(const std::string& text) {
  print(stdout, kClear + text);
}

void clear_line() {
  if (is_terminal()) print(stdout, kClear);
}

}  // namespace markservo::recorder
