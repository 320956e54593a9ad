#pragma once

// What a person reads.

#include <string>

namespace markservo::recorder {

// One line of what happens, on the standard output.
void say(const std::string& text);

// One line on the standard error.
void warn(const std::string& text);

// Whether the standard output is a terminal; there, one line that is shown anew again and again, and is cleared.
bool is_terminal();
void show(const std::string& text);
void clear_line();

}  // namespace markservo::recorder
