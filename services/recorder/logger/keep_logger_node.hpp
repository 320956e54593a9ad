#pragma once

#include <string>
#include <vector>

namespace markservo::recorder {

// Runs lcm-logger so that what it has received is on disk when it ends, however the recorder ends: told to end it lets
// lcm-logger write what waits, and then ends it. `words`: RECORDER (process id of the recorder), WORDS (the descriptor
// that gets what lcm-logger says), and lcm-logger's arguments. The exit code is keeper_exit_code's, or 2 for words that
// are none.
int keep_logger(const std::vector<std::string>& words);

}  // namespace markservo::recorder
