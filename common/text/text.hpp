#pragma once

// Texts that others wrote, made harmless: what a message's text may hold, and how any text is shown to a person.
//
// Harmful are bytes that are not UTF-8, control characters (C0, C1, DEL: they move the cursor, ring, end a line and
// begin a forged one) and the marks that turn the direction of writing (U+061C, U+200E, U+200F, U+202A to U+202E,
// U+2066 to U+2069: what follows is shown in another order than it stands).

#include <cstddef>
#include <string>
#include <string_view>

namespace markservo::text {

// A message's text is at most this long, bytes: every text is one line to be read, and what is remembered of it and
// sent again with every answer stays small.
inline constexpr std::size_t kMaxBytes = 200;

// Why `text` may not stand in a message or a name, naming `field`; empty if it may: at most kMaxBytes, nothing harmful.
std::string violation(std::string_view field, std::string_view text);

// Makes `text` one that may stand in a message: control characters become spaces, what else is harmful '?'; what is too
// long is cut between two characters, and "..." says so. A text that may stand is left as it is.
void clean(std::string& text);
std::string cleaned(std::string text);

// Whether `text` is a whole number as people write it, with a sign or without: 0640, which programs read as 416, and
// 0x10 are none.
bool is_decimal(std::string_view text);

// `text` as it may be logged or shown, of any length: what is harmful is written out as \n, \x1b, \u202e.
std::string printable(std::string_view text);

}  // namespace markservo::text
