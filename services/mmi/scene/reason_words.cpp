#include "services/mmi/scene/reason_words.hpp"

#include <cstddef>
#include <string_view>

namespace markservo::mmi {
namespace {

bool is_digit(char character) {
  return character >= '0' && character <= '9';
}

bool is_in_name(char character) {
  return (character >= 'a' && character <= 'z') || (character >= 'A' && character <= 'Z') || character == '_';
}

bool is_sign(char character) {
  return character == '-' || character == '+';
}

// The length of the number that `text` begins with, 0 if it begins with none: "-0.31", "12", "1e-05".
std::size_t number_length(std::string_view text) {
  const auto at = [&](std::size_t i) { return i < text.size() ? text[i] : '\0'; };
  std::size_t end = is_sign(at(0)) ? 1 : 0;
  if (!is_digit(at(end))) return 0;
  while (is_digit(at(end)) || (at(end) == '.' && is_digit(at(end + 1)))) ++end;
  if (at(end) != 'e') return end;
  std::size_t exponent = end + (is_sign(at(end + 1)) ? 2 : 1);
  if (!is_digit(at(exponent))) return end;
  while (is_digit(at(exponent))) ++exponent;
  return exponent;
}

}  // namespace

std::string reason_words(const std::string& reason) {
  std::string words;
  for (std::size_t i = 0; i < reason.size();) {
    const char before = i == 0 ? ' ' : reason[i - 1];
    const bool within_name = is_in_name(before) || is_digit(before);
    const std::size_t length = within_name ? 0 : number_length(std::string_view(reason).substr(i));
    if (length == 0) {
      words += reason[i++];
    } else {
      words += '#';
      i += length;
    }
  }
  return words;
}

}  // namespace markservo::mmi
