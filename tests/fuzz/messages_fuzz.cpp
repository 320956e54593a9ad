// The bus's way from bytes to messages: whatever bytes arrive on a channel of any type give a message that keeps its
// type's rules or a reason; what is accepted can be sent again, and arrives as it was.
// Input: one byte that tells the type, then the message with its fingerprint.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "common/bus/safe_decode.hpp"
#include "tests/fuzz/channel_types.hpp"
#include "tests/fuzz/require.hpp"

namespace markservo::bus {
namespace {

using fuzz::require;

template <class M>
void receive(const std::uint8_t* bytes, std::size_t size) {
  const Decoded<M> decoded = safe_decode<M>(bytes, size);
  require(decoded.ok == decoded.error.empty(), "what cannot be decoded has a reason");
  if (!decoded.ok) return;
  M mended = decoded.message;
  if (messages::mend_if_it_must_be_obeyed(mended)) {
    const std::string why = messages::broken_rule(mended);
    const bool is_of_asker = why.rfind("session", 0) == 0 || why.find("_id is") != std::string::npos;
    require(why.empty() || is_of_asker, "what must be obeyed is harmless, whoever asks");
  }
  if (!messages::broken_rule(decoded.message).empty()) return;
  require(decoded.message.getEncodedSize() == static_cast<int>(size), "a message is as long as its bytes");
  std::vector<std::uint8_t> sent(size);
  require(decoded.message.encode(sent.data(), 0, static_cast<int>(size)) == static_cast<int>(size),
          "what is accepted can be sent");
  const Decoded<M> again = safe_decode<M>(sent.data(), sent.size());
  require(again.ok && messages::broken_rule(again.message).empty(), "what is sent is accepted");
}

template <class... Types>
void receive_any(std::size_t number, const std::uint8_t* bytes, std::size_t size, fuzz::Channels<Types...> /*types*/) {
  using Receive = void (*)(const std::uint8_t*, std::size_t);
  constexpr Receive kReceivers[] = {receive<Types>...};
  kReceivers[number % sizeof...(Types)](bytes, size);
}

}  // namespace
}  // namespace markservo::bus

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  if (size > 0) markservo::bus::receive_any(bytes[0], bytes + 1, size - 1, markservo::fuzz::ChannelTypes{});
  return 0;
}
