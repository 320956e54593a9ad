#include "common/bus/connection.hpp"

#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

#include "common/bus/bus_unavailable.hpp"
#include "common/bus/bus_url.hpp"
#include "common/bus/log_not_written.hpp"
#include "common/bus/network_check.hpp"

namespace markservo::bus {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kAskAgain{250};
constexpr milliseconds kAMoment{100};        // so long may whoever asks be kept from its work four times a second,
constexpr milliseconds kAskSlowAgain{2000};  // and for longer only so often
constexpr milliseconds kLately{2000};
constexpr std::size_t kOneDatagram = 65'000;  // bytes that surely fit into one

// The network is gone, not this one message refused.
bool tells_of_loss(int error) {
  return error == ENETUNREACH || error == ENETDOWN || error == EHOSTUNREACH || error == ENODEV ||
         error == EADDRNOTAVAIL;
}

bool is_refusal(int error) {
  return tells_of_loss(error) || error == EPERM || error == EACCES || error == ENOBUFS || error == EMSGSIZE ||
         error == EINVAL || error == ECONNREFUSED || error == EPIPE;
}

[[noreturn]] void refuse_url(const std::string& url) {
  throw BusUnavailable("bus " + url + ": cannot be joined; allowed: udpm://, tcpq://, memq:// or file:// URLs");
}

// A server that takes or gives nothing any more keeps nobody for longer: liblcm then takes it for gone.
void bound_patience(int descriptor) {
  const timeval patience{1, 0};
  setsockopt(descriptor, SOL_SOCKET, SO_SNDTIMEO, &patience, sizeof patience);
  setsockopt(descriptor, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
}

}  // namespace

Connection::Connection(std::string url, Attach attach) : url_(std::move(url)), attach_(std::move(attach)) {}

bool Connection::open() {
  if (is_file(url_) && !is_written_file(url_) && access(file_path(url_).c_str(), R_OK) != 0) {
    throw BusUnavailable("bus " + url_ + ": the log cannot be read; allowed: an existing LCM log");
  }
  return try_to_open();
}

bool Connection::try_to_open() {
  // liblcm would print a line of its own.
  if (!is_udpm(url_) && !is_tcpq(url_) && !is_memq(url_) && !is_file(url_)) refuse_url(url_);
  const Reachability found = reach(url_, attach_ != nullptr);
  if (found.kind == Reachability::Kind::kNever) {
    throw BusUnavailable("bus " + url_ + ": cannot be joined: " + found.reason);
  }
  if (found.kind != Reachability::Kind::kReachable) {
    lost_ = true;
    trouble_ = found.reason;
    return false;
  }
  descriptor_ = -1;
  lcm_.reset();  // the old one's descriptors first
  if (is_written_file(url_) && !log_) log_ = std::make_unique<LogOutput>(file_path(url_));
  auto opened = std::make_unique<lcm::LCM>(log_ ? "memq://" : url_);
  if (!opened->good()) refuse_url(url_);
  if (is_tcpq(url_)) bound_patience(opened->getFileno());
  if (attach_) {
    attach_(*opened);
    descriptor_ = opened->getFileno();  // with it liblcm makes what it hears by
    if (descriptor_ < 0) {
      lost_ = true;
      trouble_ = "liblcm cannot hear on it";
      return false;
    }
  }
  lcm_ = std::move(opened);
  ++openings_;
  lost_ = false;
  trouble_.clear();
  refused_.lately = 0;
  return true;
}

bool Connection::mend(Time now) {
  if (is_open() || now - asked_ < ask_again_) return false;
  asked_ = now;
  const Time begin = std::chrono::steady_clock::now();
  bool opened = false;
  try {
    opened = try_to_open();
  } catch (const BusUnavailable& error) {
    // The URL was right at the start: whatever it is now (a host without memory, a full table of files), it may pass.
    trouble_ = error.what();
  }
  ask_again_ = std::chrono::steady_clock::now() - begin > kAMoment ? kAskSlowAgain : kAskAgain;
  return opened;
}

void Connection::lose(const std::string& why, Time now) {
  if (lost_) return;
  lost_ = true;
  trouble_ = why;
  ask_again_ = kAskAgain;
  asked_ = now;  // the first question after a moment: a bus that flaps is not opened again and again
}

bool Connection::publish(const Outgoing& message, Time now) {
  // liblcm would connect anew, and wait for it.
  if (is_tcpq(url_) && lcm_ && lcm_->getFileno() < 0) lose("the LCM server is gone", now);
  const bool may_send = lcm_ && !(is_tcpq(url_) && lost_);
  errno = 0;
  bool sent = may_send && put(message);
  const int error = may_send ? errno : ENETUNREACH;
  // liblcm 1.3.1 returns 0 for a message of several datagrams whatever became of them: errno tells.
  if (sent && is_udpm(url_) && message.size >= kOneDatagram) sent = !is_refusal(error);
  if (sent) return true;
  if (now - refused_at_ > kLately) refused_.lately = 0;
  refused_at_ = now;
  ++refused_.lately;
  ++refused_.total;
  refused_.channel = message.channel;
  refused_.reason = error == 0 ? "refused" : std::strerror(error);
  if (tells_of_loss(error)) lose(refused_.reason + "; " + multicast_route_advice(), now);
  return false;
}

bool Connection::put(const Outgoing& message) {
  if (log_) return log_->write(message);
  return lcm_->publish(message.channel, message.data, static_cast<unsigned int>(message.size)) >= 0;
}

void Connection::finish() {
  if (!is_file(url_)) return;
  if (refused_.total > 0) throw LogNotWritten(file_path(url_), refused_.reason);
  if (log_ && !log_->flush()) throw LogNotWritten(file_path(url_), std::strerror(errno));
}

int Connection::handle(milliseconds timeout) {
  // liblcm aborts when it waits on a socket that it has closed, as it does when its server goes.
  if (is_tcpq(url_) && lcm_->getFileno() < 0) return -1;
  return lcm_->handleTimeout(static_cast<int>(timeout.count()));
}

RefusedSends Connection::refused_sends(Time now) const {
  RefusedSends refused = refused_;
  if (now - refused_at_ > kLately) refused.lately = 0;
  return refused;
}

}  // namespace markservo::bus
