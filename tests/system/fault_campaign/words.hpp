#pragma once

#include <cstdio>
#include <string>

namespace markservo::campaign {

// As printf.
template <class... Values>
std::string text(const char* format, Values... values) {
  char buffer[512];
  std::snprintf(buffer, sizeof buffer, format, values...);
  return buffer;
}

// What in `printed` could command a terminal, forge a line or is no text: C0 but newline and tab, DEL, C1, marks that
// turn the direction of writing, what is no UTF-8. Empty when it is clean; else what and where.
std::string unclean(const std::string& printed);

}  // namespace markservo::campaign
