#pragma once

// A client of a web server behind a socket with a path, byte by byte: what it sends is what the test says.

#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>

namespace markservo::mmi {

class WebPeer {
 public:
  explicit WebPeer(const std::string& path) : socket_(::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0)) {
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    path.copy(address.sun_path, sizeof address.sun_path - 1);
    if (::connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0) {
      throw std::runtime_error("no server at " + path);
    }
  }
  ~WebPeer() { ::close(socket_); }
  WebPeer(const WebPeer&) = delete;
  WebPeer& operator=(const WebPeer&) = delete;

  // Sends what goes; false when the server has hung up.
  bool send(const std::string& bytes) { return ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) > 0; }

  // Takes what has come into received(), up to `most` bytes of it.
  void receive(std::size_t most = SIZE_MAX) {
    std::array<char, 65536> buffer{};
    while (most > 0) {
      const ssize_t count = ::recv(socket_, buffer.data(), std::min(most, buffer.size()), 0);
      if (count == 0) ended_ = true;
      if (count <= 0) return;
      received_.append(buffer.data(), static_cast<std::size_t>(count));
      most -= static_cast<std::size_t>(count);
    }
  }
  const std::string& received() const { return received_; }
  void forget() { received_.clear(); }
  bool ended() const { return ended_; }

  bool get(const std::string& target, const std::string& host = "localhost", const std::string& headers = "") {
    return send("GET " + target + " HTTP/1.1\r\nHost: " + host + "\r\n" + headers + "\r\n");
  }
  static std::string socket_request(const std::string& origin = "http://localhost") {
    return "GET /socket HTTP/1.1\r\nHost: localhost\r\nOrigin: " + origin +
           "\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n"
           "Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\n\r\n";
  }
  bool open_socket(const std::string& origin = "http://localhost") { return send(socket_request(origin)); }
  // A text of the WebSocket (RFC 6455, 5.2), masked by zeros.
  bool say(const std::string& text) {
    std::string frame("\x81", 1);
    if (text.size() < 126) {
      frame += static_cast<char>(0x80 | text.size());
    } else {
      frame += static_cast<char>(0x80 | 126);
      frame += static_cast<char>(text.size() >> 8 & 0xff);
      frame += static_cast<char>(text.size() & 0xff);
    }
    return send(frame + std::string(4, '\0') + text);
  }

 private:
  int socket_;
  std::string received_;
  bool ended_ = false;
};

}  // namespace markservo::mmi
