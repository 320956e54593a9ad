#include "services/mmi/mmi_options.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "common/bus/options.hpp"
#include "common/robot/configuration_error.hpp"
#include "services/mmi/server/client_word.hpp"
#include "services/mmi/server/request_rules.hpp"

namespace markservo::mmi {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kShortestToken = 16;  // characters: nobody guesses it
constexpr std::size_t kLongestPath = 107;   // bytes, of a socket (unix(7))

constexpr std::size_t kTokenBytes = 16;  // 128 bits

std::string random_token() {
  std::array<unsigned char, kTokenBytes> bytes{};
  if (::getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw ConfigurationError("no random bytes for a token: " + std::system_category().message(errno));
  }
  std::string token;
  for (const unsigned char byte : bytes) token += fmt::format("{:02x}", byte);
  return token;
}

fs::path programs_folder() {
  std::error_code none;
  return fs::read_symlink("/proc/self/exe", none).parent_path();
}

// What an installed program has beside it.
fs::path installed_folder() {
  return (programs_folder() / "../../../share/markservo").lexically_normal();
}

}  // namespace

void add_options(CLI::App& app, MmiOptions& options) {
  const bus::Options add(app);
  add.option("--listen", options.listen,
             "ADDRESS:PORT, or the path of a socket to make. An address that others reach needs --token-file")
      .show_default();
  add.option("--host", options.hosts, "A name besides loopback ones by which a browser may ask for it");
  add.option("--token-file", options.token_file,
             "A file with a secret of 16 characters or more: who sees anything but the page's files must have it "
             "(http://.../#token=SECRET)");
  add.flag("--enable-commands", options.enable_commands,
           "Let who shows the token of commands start, drive, abort, send home and reset the robot from the page");
  add.option("--command-token-file", options.command_token_file,
             "With --enable-commands: the file with that token, which its user alone may read. Made, with a new token, "
             "where it is missing");
  add.option("--log", options.log,
             "Show this log, or recording's folder, in place of the bus; then no bus is opened and nothing is sent");
  add.option("--page", options.page, "The folder with the page (default: as it was built or installed)");
  add.option("--tag-field", options.tag_field,
             "The field of floor tags, where it is another than robot.yaml's in_use: what rfid-localizer was given");
  add.footer("Exit codes: 0 told to end; 2 bad configuration, a place to listen at that is taken among it; 3 no bus.");
}

ListenPlace listen_place(const std::string& text) {
  if (text.find('/') != std::string::npos) {
    if (text.size() > kLongestPath) {
      throw ConfigurationError("--listen " + text + ": a path of " + std::to_string(text.size()) +
                               " bytes; allowed: up to " + std::to_string(kLongestPath));
    }
    return {"", 0, text};
  }
  const std::size_t colon = text.rfind(':');
  ListenPlace place;
  bool good = colon != std::string::npos && colon > 0;
  if (good) {
    const char* end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data() + colon + 1, end, place.port);
    good = error == std::errc() && rest == end && place.port >= 1 && place.port <= 65535;
    place.address = text.substr(0, colon);
  }
  if (good && place.address.front() == '[' && place.address.back() == ']') {
    place.address = place.address.substr(1, place.address.size() - 2);
  }
  if (place.address == "localhost") place.address = "127.0.0.1";
  if (!good) {
    throw ConfigurationError("--listen " + text + "; allowed: ADDRESS:PORT such as 127.0.0.1:8080, or a path with a /");
  }
  return place;
}

bool is_private(const ListenPlace& place) {
  return place.is_path() || place.address == "::1" || is_loopback_name(place.address);
}

std::string read_token(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(kLongestText + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file.is_open() || file.bad()) {
    throw ConfigurationError("--token-file " + path + ": cannot be read; allowed: a file with a secret");
  }
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.empty()) throw ConfigurationError("--token-file " + path + ": is empty; allowed: a file with a secret");
  if (text.size() > kLongestText) {
    throw ConfigurationError("--token-file " + path + ": more than " + std::to_string(kLongestText) +
                             " bytes; allowed: up to so many, the secret in the first line");
  }
  std::string token = text.substr(0, text.find('\n'));
  if (!token.empty() && token.back() == '\r') token.pop_back();
  if (token.size() < kShortestToken) {
    throw ConfigurationError("--token-file " + path + ": " + std::to_string(token.size()) +
                             " characters; allowed: at least " + std::to_string(kShortestToken));
  }
  return token;
}

std::string command_token(const std::string& path) {
  const auto wrong = [&path](const std::string& why) {
    return ConfigurationError("--command-token-file " + path + ": " + why);
  };
  const int made = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, S_IRUSR | S_IWUSR);
  if (made >= 0) {
    std::string token = random_token();
    const std::string line = token + "\n";
    const bool written = ::write(made, line.data(), line.size()) == static_cast<ssize_t>(line.size());
    ::close(made);
    if (!written) throw wrong("cannot be written");
    return token;
  }
  if (errno != EEXIST) throw wrong("cannot be made: " + std::system_category().message(errno));
  struct stat status {};
  if (::lstat(path.c_str(), &status) != 0 || !S_ISREG(status.st_mode)) throw wrong("is no file");
  if ((status.st_mode & (S_IRWXG | S_IRWXO)) != 0) {
    throw wrong("others may read or write it; allowed: its user alone (chmod 600)");
  }
  return read_token(path);
}

std::string default_page_folder() {
  std::error_code none;
  const fs::path built = programs_folder() / "../page";
  if (fs::exists(built, none)) return built.lexically_normal().string();
  return (installed_folder() / "page").string();
}

text::TypedCommand typed_command() {
  std::error_code none;
  return fs::exists(installed_folder() / "scripts", none) ? text::TypedCommand("markservo page") : text::TypedCommand();
}

}  // namespace markservo::mmi
