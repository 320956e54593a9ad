#pragma once

#include <string>

namespace markservo::mmi {

// The reason with "#" for each number in it, so that two of them are equal that differ in measured values only. Digits
// within a name (book_2) stay.
std::string reason_words(const std::string& reason);

}  // namespace markservo::mmi
