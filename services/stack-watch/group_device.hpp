#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace markservo::stack_watch {

// Where an LCM bus is on the network: what a URL of the form udpm://GROUP:PORT?ttl=N&recv_buf_size=N says.
struct GroupAddress {
  std::string group = "239.255.76.67";
  int port = 7667;
  int ttl = 0;
  int receive_buffer = 0;  // bytes; 0: the kernel's default
};

// Throws ConfigurationError for another URL, and for numbers that are none.
GroupAddress group_address(const std::string& url);

// One datagram as it came; `size` bytes at `data`.
struct Datagram {
  const void* data = nullptr;
  std::size_t size = 0;
  std::string from;  // "ADDRESS:PORT"
};

// A multicast group's datagrams, in and out, without liblcm, which a crafted one kills. While there is no network it is
// closed; open() tries again.
class GroupDevice {
 public:
  explicit GroupDevice(GroupAddress address) : address_(std::move(address)) {}
  ~GroupDevice() { shut(); }
  GroupDevice(const GroupDevice&) = delete;
  GroupDevice& operator=(const GroupDevice&) = delete;

  // Joins the group, anew where it had; the reason why not, or an empty text.
  std::string open();
  void shut();
  bool is_open() const { return descriptor_ >= 0; }

  // Waits so long for a datagram, and hands over it and what waits behind it.
  void poll(std::chrono::milliseconds timeout, const std::function<void(const Datagram&)>& handler);
  // Whether the kernel took it.
  bool send(const std::vector<std::uint8_t>& bytes) const;

 private:
  GroupAddress address_;
  int descriptor_ = -1;
  std::vector<std::uint8_t> buffer_ = std::vector<std::uint8_t>(65536);
};

}  // namespace markservo::stack_watch
