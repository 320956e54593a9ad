#include "services/mmi/web_loop_node.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>

#include "common/bus/bus.hpp"

namespace markservo::mmi {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

constexpr std::chrono::milliseconds kTick{20};  // signals, silences and updates that are due are seen so late at most

// The page's own files alone; pictures it makes of bytes.
constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; connect-src 'self'; "
    "font-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

class Loop {
 public:
  Loop(SiteNode& site, const ListenPlace& place, const bus::Bus* bus, const std::function<bool()>& work)
      : bus_(bus), work_(work), server_(io_, place, parameters(), site), timer_(io_), heard_(io_) {
    site.count(server_.refusals());
  }
  ~Loop() { heard_.release(); }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  void run() {
    tick();
    io_.run();
  }

 private:
  static ServerParameters parameters() {
    ServerParameters parameters;
    parameters.content_security_policy = kContentSecurityPolicy;
    return parameters;
  }

  void work() {
    if (!work_()) {
      io_.stop();
      return;
    }
    server_.wake();
    listen();
  }

  void tick() {
    work();
    timer_.expires_after(kTick);
    timer_.async_wait([this](error_code ended) {
      if (!ended) tick();
    });
  }

  // The bus has another descriptor after its network was gone, and none while it is.
  void listen() {
    const int descriptor = bus_ == nullptr ? -1 : bus_->descriptor();
    if (heard_.is_open() && heard_.native_handle() != descriptor) {
      heard_.release();
      waiting_ = false;
    }
    if (descriptor < 0 || waiting_) return;
    if (!heard_.is_open()) heard_.assign(descriptor);
    waiting_ = true;
    heard_.async_wait(asio::posix::stream_descriptor::wait_read, [this](error_code error) {
      if (error) return;
      waiting_ = false;
      work();
    });
  }

  const bus::Bus* bus_;
  const std::function<bool()>& work_;
  asio::io_context io_;
  Server server_;
  asio::steady_timer timer_;
  asio::posix::stream_descriptor heard_;
  bool waiting_ = false;
};

}  // namespace

void serve(SiteNode& site, const ListenPlace& place, const bus::Bus* bus, const std::function<bool()>& work) {
  Loop(site, place, bus, work).run();
}

}  // namespace markservo::mmi
