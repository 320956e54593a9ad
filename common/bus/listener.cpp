#include "common/bus/listener.hpp"

#include <cerrno>
#include <utility>

#include "common/bus/bus.hpp"
#include "common/bus/end_signals.hpp"
#include "common/bus/network_check.hpp"

namespace markservo::bus {

Listener::Listener(const std::string& url, const std::string& pattern, int queue, Handler handler)
    : url_(url), handler_(std::move(handler)), lcm_(url) {
  if (!lcm_.good()) throw BusUnavailable("bus " + url + ": cannot be joined; " + multicast_route_advice());
  lcm_.subscribeFunction(pattern, receive, this)->setQueueCapacity(queue);
  note_end_signals(true);
}

void Listener::receive(const lcm::ReceiveBuffer* buffer, const std::string& channel, Listener* listener) {
  listener->handler_({channel, buffer->data, buffer->data_size, buffer->recv_utime});
}

void Listener::poll(std::chrono::milliseconds timeout) {
  constexpr int kMaxDrain = 4096;  // so that a flood cannot keep the caller from its other work
  errno = 0;
  int handled = lcm_.handleTimeout(static_cast<int>(timeout.count()));
  for (int count = 1; handled > 0 && count < kMaxDrain; ++count) handled = lcm_.handleTimeout(0);
  if (handled < 0 && errno != EINTR && !told_to_end()) {
    throw BusUnavailable("bus " + url_ + ": cannot be read any more");
  }
}

}  // namespace markservo::bus
