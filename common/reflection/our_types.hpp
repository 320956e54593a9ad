#pragma once

#include <string>
#include <vector>

namespace markservo::reflection {

struct EmbeddedText {
  std::string name;  // the file's
  std::string text;
};

// The files of lcmtypes/, put into the executable by EmbedTypes.cmake: a tool needs no folder beside it.
std::vector<EmbeddedText> our_types();

}  // namespace markservo::reflection
