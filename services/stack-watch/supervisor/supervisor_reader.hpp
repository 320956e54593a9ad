#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "services/stack-watch/supervisor/supervisor_words.hpp"

namespace markservo::stack_watch {

// supervisord does not answer.
class SupervisorSilent : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// It cannot be asked from here, for want of descriptors or memory: that says nothing of it.
class CannotAsk : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Asks supervisord on its socket at `path` for all its processes; it has 2 s. Throws SupervisorSilent and CannotAsk.
std::vector<SupervisedProcess> ask_supervisor(const std::string& path);

}  // namespace markservo::stack_watch
