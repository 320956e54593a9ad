#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace markservo::stack_watch {

// The watch's own SERVICE_STATUS: it tells others how the stack is, and, when it comes back, that there is a bus.
class OwnWord {
 public:
  // `robot`: prefix of the channel.
  explicit OwnWord(const std::string& robot);

  const std::string& host() const { return host_; }
  std::int64_t session() const { return session_; }

  // The next one, as a datagram. `wall_us`: wall clock; `reason`: cut to what a text on the bus may have.
  std::vector<std::uint8_t> next(bool well, const std::string& reason, std::int64_t wall_us);

 private:
  std::string channel_;
  std::string host_;
  std::int64_t session_;
  std::int64_t seq_ = 0;
};

}  // namespace markservo::stack_watch
