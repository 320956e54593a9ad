#include "common/bus/listener.hpp"

#include <cerrno>
#include <utility>

#include "common/bus/bus_unavailable.hpp"
#include "common/bus/end_signals.hpp"
#include "common/bus/reachability.hpp"

namespace markservo::bus {

namespace {

// The URL, if it can be joined.
const std::string& reachable(const std::string& url) {
  const Reachability found = reach(url, true);
  if (found.kind == Reachability::Kind::kReachable) return url;
  throw BusUnavailable("bus " + url + ": cannot be joined: " + found.reason);
}

}  // namespace

Listener::Listener(const std::string& url, const std::string& pattern, int queue, Handler handler)
    : url_(reachable(url)), handler_(std::move(handler)), lcm_(url) {
  if (!lcm_.good()) throw BusUnavailable("bus " + url + ": cannot be joined");
  lcm_.subscribeFunction(pattern, receive, this)->setQueueCapacity(queue);
  if (lcm_.getFileno() < 0) throw BusUnavailable("bus " + url + ": cannot be heard");
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
