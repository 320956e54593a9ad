#pragma once

#include <string>
#include <vector>

namespace markservo::stack_watch {

// The arguments that a process of this host was run with; none where it is gone, or cannot be asked.
std::vector<std::string> command_line_of(int pid);

// Whether that is the command line of the service `name` itself, not of what runs it, and it speaks on the bus `url`:
// it names no other.
bool must_speak(const std::vector<std::string>& command_line, const std::string& name, const std::string& url);

}  // namespace markservo::stack_watch
