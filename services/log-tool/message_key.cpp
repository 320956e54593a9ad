#include "services/log-tool/message_key.hpp"

#include <utility>

#include "common/reflection/message_value.hpp"

namespace markservo::log_tool {

namespace {

bool begins_with_an_integer(const reflection::MessageType& type) {
  return !type.fields.empty() && type.fields[0].kind == reflection::Kind::kInt64 && type.fields[0].dimensions.empty();
}

}  // namespace

std::int64_t message_utime(const logs::LogEvent& event, const reflection::TypeCatalog& types) {
  constexpr std::size_t kFingerprintSize = 8;
  std::uint64_t utime = 0;
  if (event.data.size < kFingerprintSize ||
      !reflection::read_fingerprint(event.data.data + kFingerprintSize, event.data.size - kFingerprintSize, &utime)) {
    return 0;
  }
  std::uint64_t fingerprint = 0;
  reflection::read_fingerprint(event.data.data, event.data.size, &fingerprint);
  const reflection::MessageType* type = types.find(fingerprint);
  return type == nullptr || begins_with_an_integer(*type) ? static_cast<std::int64_t>(utime) : 0;
}

MessageKey MessageKeys::next(const logs::LogEvent& event) {
  const std::pair<std::string, std::int64_t> place(event.channel, message_utime(event, types_));
  return {place.first, place.second, seen_[place]++};
}

}  // namespace markservo::log_tool
