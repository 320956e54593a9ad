#pragma once

// A recording's files: log.lcm, or, when a file was full or a new lcm-logger began, log.lcm.00, log.lcm.01, ... The
// numbers grow and are never used twice, so that their order is the order in which they were written.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace markservo::recorder {

inline constexpr const char* kLogName = "log.lcm";

struct Part {
  std::string name;
  std::int64_t bytes = 0;
};

// The number at the end of a part's name; -1 for log.lcm itself; nothing for a name that is no part's.
std::optional<std::int64_t> part_number(const std::string& name);

// Those of the files in a folder that are parts, in the order in which they were written.
std::vector<Part> parts_in_order(std::vector<Part> files);

// The names of all but the newest `keep`.
std::vector<std::string> parts_to_remove(const std::vector<Part>& parts, std::size_t keep);

// What an lcm-logger that begins now is given to write.
struct NextPart {
  std::string file;  // that it is told
  // With --split-mb it numbers parts by itself, from the first name that is free. Those that were removed are free as
  // well, and new parts would come before old ones: empty files hold these places until it has begun.
  std::vector<std::string> places_to_hold;
};

// `parts` as parts_in_order gives them; `runs`: so many loggers have begun.
NextPart next_part(const std::vector<Part>& parts, bool split, int runs);

// Once it has begun: the empty files that held a place. The newest part is one although it may be empty.
std::vector<std::string> held_places(const std::vector<Part>& parts);

}  // namespace markservo::recorder
