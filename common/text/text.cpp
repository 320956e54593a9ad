#include "common/text/text.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>

namespace markservo::text {
namespace {

constexpr std::string_view kCut = "...";

struct Character {
  std::size_t size = 1;  // bytes
  char32_t code = 0;     // of a byte that begins no character: the byte
  bool is_utf8 = true;
};

// The bytes of the character that `lead` begins; 0 if it begins none.
std::size_t size_by_lead(std::uint8_t lead) {
  if (lead < 0x80) return 1;
  if (lead >= 0xC2 && lead <= 0xDF) return 2;
  if (lead >= 0xE0 && lead <= 0xEF) return 3;
  if (lead >= 0xF0 && lead <= 0xF4) return 4;
  return 0;
}

// The character at `at`: Unicode 15, table 3-7 (no overlong forms, no surrogates, nothing above U+10FFFF).
Character character_at(std::string_view text, std::size_t at) {
  const auto lead = static_cast<std::uint8_t>(text[at]);
  const Character stray{1, lead, false};
  const std::size_t size = size_by_lead(lead);
  if (size == 0 || size > text.size() - at) return stray;
  if (size == 1) return {1, lead, true};
  char32_t code = lead & (0x7FU >> size);
  for (std::size_t i = 1; i < size; ++i) {
    const auto byte = static_cast<std::uint8_t>(text[at + i]);
    if ((byte & 0xC0U) != 0x80U) return stray;
    code = (code << 6U) | (byte & 0x3FU);
  }
  constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  const bool surrogate = code >= 0xD800 && code <= 0xDFFF;
  if (code < kLeast[size] || code > 0x10FFFF || surrogate) return stray;
  return {size, code, true};
}

bool is_control(char32_t code) {
  return code < 0x20 || (code >= 0x7F && code <= 0x9F);
}

bool turns_direction(char32_t code) {
  return code == 0x61C || code == 0x200E || code == 0x200F || (code >= 0x202A && code <= 0x202E) ||
         (code >= 0x2066 && code <= 0x2069);
}

bool is_harmful(const Character& character) {
  return !character.is_utf8 || is_control(character.code) || turns_direction(character.code);
}

std::string written_out(const Character& character) {
  if (character.is_utf8 && character.code == '\n') return "\\n";
  if (character.is_utf8 && character.code == '\r') return "\\r";
  if (character.is_utf8 && character.code == '\t') return "\\t";
  const auto code = static_cast<std::uint32_t>(character.code);
  const bool as_byte = !character.is_utf8 || code < 0x80;
  return as_byte ? fmt::format("\\x{:02x}", code) : fmt::format("\\u{:04x}", code);
}

// The first harmful character's place; text.size() if there is none.
std::size_t first_harmful(std::string_view text) {
  std::size_t at = 0;
  while (at < text.size()) {
    const Character character = character_at(text, at);
    if (is_harmful(character)) break;
    at += character.size;
  }
  return at;
}

}  // namespace

std::string violation(std::string_view field, std::string_view text) {
  if (text.size() > kMaxBytes) {
    return std::string(field) + " is " + std::to_string(text.size()) + " bytes long; allowed: at most " +
           std::to_string(kMaxBytes);
  }
  const std::size_t at = first_harmful(text);
  if (at == text.size()) return {};
  return std::string(field) + " holds " + written_out(character_at(text, at)) + " at byte " + std::to_string(at) +
         "; allowed: UTF-8 without control characters and marks of direction";
}

void clean(std::string& text) {
  if (text.size() <= kMaxBytes && first_harmful(text) == text.size()) return;
  std::string clean_one;
  std::size_t room_for_cut = 0;  // the longest beginning that leaves room for kCut
  std::size_t at = 0;
  while (at < text.size() && clean_one.size() <= kMaxBytes) {
    const Character character = character_at(text, at);
    if (!is_harmful(character)) {
      clean_one.append(text, at, character.size);
    } else {
      clean_one += character.is_utf8 && is_control(character.code) ? ' ' : '?';
    }
    at += character.size;
    if (clean_one.size() + kCut.size() <= kMaxBytes) room_for_cut = clean_one.size();
  }
  if (at < text.size() || clean_one.size() > kMaxBytes) {
    clean_one.resize(room_for_cut);
    clean_one += kCut;
  }
  text = std::move(clean_one);
}

std::string cleaned(std::string text) {
  clean(text);
  return text;
}

bool is_decimal(std::string_view text) {
  if (!text.empty() && (text.front() == '-' || text.front() == '+')) text.remove_prefix(1);
  if (text.empty() || text.find_first_not_of("0123456789") != std::string_view::npos) return false;
  return text.size() == 1 || text.front() != '0';
}

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  for (std::size_t at = 0; at < text.size();) {
    const Character character = character_at(text, at);
    if (is_harmful(character)) {
      shown += written_out(character);
    } else {
      shown.append(text, at, character.size);
    }
    at += character.size;
  }
  return shown;
}

}  // namespace markservo::text
