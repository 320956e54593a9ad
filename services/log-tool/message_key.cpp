#include "services/log-tool/message_key.hpp"

#include <utility>

#include "common/reflection/message_value.hpp"

namespace markservo::log_tool {

std::int64_t message_utime(const Event& event) {
  constexpr std::size_t kFingerprintSize = 8;
  std::uint64_t utime = 0;
  if (event.data.size < kFingerprintSize ||
      !reflection::read_fingerprint(event.data.data + kFingerprintSize, event.data.size - kFingerprintSize, &utime)) {
    return 0;
  }
  return static_cast<std::int64_t>(utime);
}

MessageKey MessageKeys::next(const Event& event) {
  const std::pair<std::string, std::int64_t> place(event.channel, message_utime(event));
  return {place.first, place.second, seen_[place]++};
}

}  // namespace markservo::log_tool
