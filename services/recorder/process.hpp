#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

namespace markservo::recorder {

// How a child begins. Its signals are as at this program's own start.
struct ChildSetup {
  // Its standard input, output and error; -1: nothing.
  int in = -1;
  int out = -1;
  int error = -1;
  std::vector<int> kept;              // descriptors that it inherits besides
  bool own_session = false;           // Ctrl-C does not reach it
  bool ends_with_parent = false;      // by SIGTERM
  bool ignores_broken_pipes = false;  // who reads what it prints may end before it
};

// Runs `path`, a file or a name to be looked for in PATH, with `arguments`, the first its own name. A child whose
// program cannot be run ends with 127. Throws std::system_error where there can be no child.
pid_t start_process(const std::string& path, const std::vector<std::string>& arguments, const ChildSetup& setup);

// A pipe, or either end of it, closed with the object; neither end is inherited. Throws std::system_error.
class Pipe {
 public:
  Pipe();
  ~Pipe();
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;

  int read_end() const { return ends_[0]; }
  int write_end() const { return ends_[1]; }
  // Closes the end that is written to, so that the reader learns of the writer's end.
  void close_write_end();
  // What is there to be read now, without waiting; at most 64 kB.
  std::string take() const;

 private:
  int ends_[2] = {-1, -1};
};

struct CommandOutput {
  int exit_code = -1;  // of one that ended by itself
  std::string text;    // of its standard output
};

// Runs a command to its end. Ctrl-C ends it too, unless that is ignored.
CommandOutput output_of(const std::vector<std::string>& command);

// Where the standard input, output or error is closed, a descriptor of ours would take its number: opens it.
void open_standard_descriptors();

// Whether PATH has an executable of that name.
bool is_in_path(const std::string& name);

}  // namespace markservo::recorder
