#pragma once

// LCM's datagrams (UDP multicast, as LCM 1.3 writes them): what one tells without the others that belong to it. Made
// for who must not fall to a hostile one: nothing is put together, and nothing beyond the bytes that came is read.
//   short:    "LC02", number of the message, channel, 0, payload
//   fragment: "LC03", number of the message, size of the message, offset, number of the fragment (16 bits), how many
//             there are (16 bits); then in fragment 0 channel and 0; then a part of the payload
// All numbers are unsigned, big end first, of 32 bits but where said.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace markservo::stack_watch {

struct LcmDatagram {
  std::string channel;
  const std::uint8_t* payload = nullptr;  // the bytes of it that came
  std::size_t size = 0;
  std::size_t message_size = 0;  // of the whole payload
  bool whole = false;            // all of the message is in it
};

// A message's beginning: a short message, or fragment 0 of a longer one. Nothing for later fragments, and for what is
// no such datagram.
std::optional<LcmDatagram> read_datagram(const void* data, std::size_t size);

// A fragment that says it lies outside of its message: no LCM writes such, and liblcm up to 1.3.1 writes it over its
// memory. `datagram_size` may exceed `size`, the bytes of it that are there.
bool is_crafted(const void* data, std::size_t size, std::size_t datagram_size);

// A short message.
std::vector<std::uint8_t> short_message(std::uint32_t number, const std::string& channel,
                                        const std::vector<std::uint8_t>& payload);

}  // namespace markservo::stack_watch
