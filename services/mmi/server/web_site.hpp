#pragma once

// What a web server asks of who has something to show. Knows no socket.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace markservo::mmi {

// The parts of a request that decide whether it is answered.
struct RequestHead {
  std::string method;
  std::string target;  // path and query, as sent
  std::string host;    // the header; empty where there is none
  std::optional<std::string> origin;
  std::string fetch_site;  // Sec-Fetch-Site, which browsers send; empty where there is none
  std::string fetch_mode;  // Sec-Fetch-Mode and Sec-Fetch-Dest, likewise
  std::string fetch_destination;
  std::string bearer;    // of "Authorization: Bearer ..."; empty where there is none
  bool upgrade = false;  // asks for a WebSocket
  bool by_path = false;  // came by a socket with a path
};

struct Answer {
  int status = 200;
  std::string content_type = "text/plain; charset=utf-8";
  std::shared_ptr<const std::string> body;
};

struct OutgoingMessage {
  std::shared_ptr<const std::string> data;
  bool binary = false;
};

// One WebSocket's conversation.
class Conversation {
 public:
  virtual ~Conversation() = default;

  // A text of the client's. Returns why the connection must end; empty while all is well.
  virtual std::string hear(std::string_view text) = 0;
  // Whether it has said who it is.
  virtual bool greeted() const = 0;
  // What to send next, nothing for now. Asked whenever the one before is out, and by Server::wake().
  virtual std::optional<OutgoingMessage> next() = 0;
  // Why it must end although the client did nothing wrong: it cannot keep up. Empty while all is well.
  virtual std::string trouble() const = 0;
};

// What was refused, since the start.
struct Refusals {
  std::int64_t requests = 0;     // a Host, an Origin or a method that is not allowed, or no token
  std::int64_t malformed = 0;    // no HTTP or WebSocket, a header or message too large, a message none of the protocol
  std::int64_t slow = 0;         // did not speak, or take its answer, in time
  std::int64_t connections = 0;  // beyond the most: turned away, or given the place of one that was idle
  std::int64_t behind = 0;       // fell too far behind
};

class WebSite {
 public:
  virtual ~WebSite() = default;

  virtual Answer answer(const RequestHead& request) = 0;
  // For a WebSocket: why it is refused; empty when it may be opened.
  virtual std::string refusal(const RequestHead& request) const = 0;
  virtual std::unique_ptr<Conversation> converse() = 0;
};

}  // namespace markservo::mmi
