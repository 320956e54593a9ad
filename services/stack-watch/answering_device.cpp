#include "services/stack-watch/answering_device.hpp"

#include <poll.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <sys/un.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <utility>

namespace markservo::stack_watch {

AnsweringDevice::AnsweringDevice(const std::string& path, std::function<std::string()> answer)
    : path_(path), answer_(std::move(answer)), descriptor_(socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  if (path.size() >= sizeof address.sun_path) throw std::runtime_error(path + ": too long for a socket's path");
  std::memcpy(address.sun_path, path.c_str(), path.size());
  unlink(path.c_str());
  if (descriptor_ < 0 || bind(descriptor_, reinterpret_cast<const sockaddr*>(&address), sizeof address) != 0 ||
      chmod(path.c_str(), S_IRUSR | S_IWUSR) != 0 || listen(descriptor_, 16) != 0) {
    const std::string why = std::strerror(errno);
    if (descriptor_ >= 0) close(descriptor_);
    throw std::runtime_error(path + ": " + why);
  }
  thread_ = std::thread([this] { serve(); });
}

AnsweringDevice::~AnsweringDevice() {
  stopped_ = true;
  thread_.join();
  close(descriptor_);
  unlink(path_.c_str());
}

void AnsweringDevice::serve() {
  constexpr int kLook_ms = 100;  // how soon the end is noticed
  while (!stopped_) {
    pollfd waiting{descriptor_, POLLIN, 0};
    const int ready = poll(&waiting, 1, kLook_ms);
    if (ready == 0) continue;
    const int client = ready < 0 ? -1 : accept4(descriptor_, nullptr, nullptr, SOCK_CLOEXEC);
    if (client < 0) {
      // Where no descriptors are left, neither waits.
      std::this_thread::sleep_for(std::chrono::milliseconds(kLook_ms));
      continue;
    }
    const timeval patience{2, 0};  // one that does not read must not keep the others waiting
    setsockopt(client, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
    const std::string text = answer_();
    std::size_t done = 0;
    while (done < text.size()) {
      const ssize_t written = send(client, text.data() + done, text.size() - done, MSG_NOSIGNAL);
      if (written <= 0) break;
      done += static_cast<std::size_t>(written);
    }
    close(client);
  }
}

}  // namespace markservo::stack_watch
