#include "services/stack-watch/supervisor/supervisor_reader.hpp"

#include <sys/socket.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>

namespace markservo::stack_watch {
namespace {

class Connection {
 public:
  explicit Connection(const std::string& path) : descriptor_(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (descriptor_ < 0) throw CannotAsk(std::strerror(errno));
    try {
      join(path);
    } catch (...) {
      close(descriptor_);
      throw;
    }
  }
  ~Connection() { close(descriptor_); }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  void write(const std::string& text) const {
    std::size_t done = 0;
    while (done < text.size()) {
      const ssize_t written = send(descriptor_, text.data() + done, text.size() - done, MSG_NOSIGNAL);
      if (written <= 0) fail("send");
      done += static_cast<std::size_t>(written);
    }
  }

  // Until the other side closes.
  std::string read() const {
    constexpr std::size_t kMost = 16 << 20;  // bytes; a hundred services are 80 kB
    std::string text;
    std::array<char, 65536> part{};
    while (text.size() < kMost) {
      const ssize_t count = recv(descriptor_, part.data(), part.size(), 0);
      if (count < 0) fail("recv");
      if (count == 0) return text;
      text.append(part.data(), static_cast<std::size_t>(count));
    }
    throw SupervisorSilent("supervisord's answer is endless");
  }

 private:
  void join(const std::string& path) const {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    if (path.size() >= sizeof address.sun_path) throw SupervisorSilent(path + ": too long for a socket's path");
    std::memcpy(address.sun_path, path.c_str(), path.size());
    const timeval patience{2, 0};
    setsockopt(descriptor_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    setsockopt(descriptor_, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    if (connect(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) fail(path);
  }

  [[noreturn]] static void fail(const std::string& what) { throw SupervisorSilent(what + ": " + std::strerror(errno)); }

  int descriptor_;
};

}  // namespace

std::vector<SupervisedProcess> ask_supervisor(const std::string& path) {
  const Connection connection(path);
  const std::string body = kAskForProcesses;
  connection.write("POST /RPC2 HTTP/1.0\r\nContent-Type: text/xml\r\nConnection: close\r\nContent-Length: " +
                   std::to_string(body.size()) + "\r\n\r\n" + body);
  try {
    return processes_in(connection.read());
  } catch (const std::invalid_argument& error) {
    throw SupervisorSilent(error.what());
  }
}

}  // namespace markservo::stack_watch
