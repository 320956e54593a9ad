#pragma once

// LCM's udpm bus without liblcm, which a crafted datagram can end: the trial hears what is sent, whatever that is, and
// sends what no honest program would.

#include <netinet/in.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace markservo::campaign {

// One message as heard. A fragmented one is told by its first fragment.
struct HeardMessage {
  std::string channel;
  std::int64_t size = 0;               // bytes of the message, all of it
  const std::uint8_t* data = nullptr;  // its beginning
  std::size_t available = 0;           // bytes at `data`
};

class MulticastBus {
 public:
  // `port` of LCM's group on this host. Throws std::runtime_error if it cannot be joined.
  explicit MulticastBus(std::uint16_t port);
  ~MulticastBus();
  MulticastBus(const MulticastBus&) = delete;
  MulticastBus& operator=(const MulticastBus&) = delete;

  int descriptor() const { return receiver_; }
  // Hands over what has come. Of fragmented messages the kernel lets only the first fragment through.
  void receive(const std::function<void(const HeardMessage&)>& handler);

  // False where the network refuses it, or some of it.
  bool send(const std::string& channel, const std::vector<std::uint8_t>& data);
  // One datagram, as it is.
  bool send_datagram(const std::vector<std::uint8_t>& bytes);

  std::int64_t refused() const { return refused_; }

 private:
  sockaddr_in group_{};
  int receiver_ = -1;
  int sender_ = -1;
  std::uint32_t sequence_ = 0;
  std::int64_t refused_ = 0;
  std::vector<std::uint8_t> buffer_;
};

// The pieces of LCM's wire format, big-endian.
std::vector<std::uint8_t> short_datagram(std::uint32_t sequence, const std::string& channel,
                                         const std::vector<std::uint8_t>& data);
std::vector<std::uint8_t> fragment_datagram(std::uint32_t sequence, std::uint32_t message_size, std::uint32_t offset,
                                            std::uint16_t number, std::uint16_t count, const std::string& channel,
                                            const std::uint8_t* data, std::size_t size);
// What a datagram tells; an empty channel for what is none of LCM's, and for all fragments but the first.
HeardMessage parse_datagram(const std::uint8_t* bytes, std::size_t size);

}  // namespace markservo::campaign
