#include "common/bus/session.hpp"

#include <fstream>
#include <limits>
#include <random>

namespace markservo::bus {
namespace {

// 0 stands for "none" in messages that echo a session.
std::int64_t positive(std::uint64_t bits) {
  const auto session =
      static_cast<std::int64_t>(bits & static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()));
  return session == 0 ? 1 : session;
}

}  // namespace

std::int64_t random_session() {
  std::random_device device;
  return positive((static_cast<std::uint64_t>(device()) << 32) | device());
}

std::int64_t replay_session(const std::string& log_path, const std::string& service_name) {
  constexpr std::size_t kHead = 65536;  // bytes; the first events already tell one log from another
  std::string head(kHead, '\0');
  std::ifstream log(log_path, std::ios::binary);
  log.read(head.data(), static_cast<std::streamsize>(kHead));
  head.resize(static_cast<std::size_t>(log.gcount()));
  return positive(fingerprint(service_name, fingerprint(head)));
}

std::int64_t source_session(const std::string& service_name) {
  return positive(fingerprint(service_name));
}

std::uint64_t fingerprint(std::string_view text, std::uint64_t seed) {
  constexpr std::uint64_t kPrime = 1099511628211ULL;
  std::uint64_t hash = seed;
  for (const char character : text) {
    hash ^= static_cast<unsigned char>(character);
    hash *= kPrime;
  }
  return hash;
}

}  // namespace markservo::bus
