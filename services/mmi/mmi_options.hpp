#pragma once

#include <string>
#include <vector>

#include "common/text/typed_command.hpp"
#include "services/mmi/server/server_device.hpp"

namespace CLI {
class App;
}

namespace markservo::mmi {

struct MmiOptions {
  std::string listen = "127.0.0.1:8080";  // ADDRESS:PORT, or a path
  std::vector<std::string> hosts;         // names besides loopback ones by which it may be asked
  std::string token_file;
  bool enable_commands = false;
  std::string command_token_file;
  std::string log;  // a log or a recording in place of the bus
  std::string page;
  std::string tag_field;
};

void add_options(CLI::App& app, MmiOptions& options);

// Where `text` says: what has a "/" is a path. Throws ConfigurationError.
ListenPlace listen_place(const std::string& text);

// Whether only this host can reach it.
bool is_private(const ListenPlace& place);

// The token in `path`, a file of up to 512 bytes: its first line, 16 characters or more. Throws ConfigurationError.
std::string read_token(const std::string& path);

// The token of commands in `path`, which its user alone may read; where there is none yet, one that nobody guesses is
// written there. Throws ConfigurationError.
std::string command_token(const std::string& path);

// Where the page is that was built with this program, or installed beside it.
std::string default_page_folder();

// How commands are called where this program stands: `scripts/...` of a checkout, `markservo ...` where it is
// installed.
text::TypedCommand typed_command();

}  // namespace markservo::mmi
