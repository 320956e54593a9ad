#include "services/mmi/web_loop_node.hpp"

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <exception>
#include <optional>
#include <string>

#include "common/bus/bus_unavailable.hpp"
#include "common/bus/log_not_written.hpp"
#include "common/logging/log.hpp"
#include "common/robot/configuration_error.hpp"

namespace markservo::mmi {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using std::chrono::steady_clock;

constexpr std::chrono::milliseconds kTick{20};  // signals, silences and updates that are due are seen so late at most
constexpr std::chrono::seconds kComplain{1};    // at most so often: what fails may fail at every tick

// The page's own files alone; pictures it makes of bytes.
constexpr const char* kContentSecurityPolicy =
    "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob:; connect-src 'self'; "
    "font-src 'none'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

std::string address_of(const ListenPlace& place) {
  if (place.is_path()) return place.path;
  const bool is_ipv6 = place.address.find(':') != std::string::npos;
  return "http://" + (is_ipv6 ? "[" + place.address + "]" : place.address) + ":" + std::to_string(place.port);
}

class Loop {
 public:
  Loop(SiteNode& site, const ListenPlace& place, const std::function<Heard()>& heard, const std::function<bool()>& work)
      : heard_(heard), work_(work), server_(io_, place, parameters(), site), timer_(io_), descriptor_(io_) {
    site.count(server_.refusals());
    logging::info("the page is at {}", address_of(place));
  }
  ~Loop() { descriptor_.release(); }
  Loop(const Loop&) = delete;
  Loop& operator=(const Loop&) = delete;

  // A STOP that is being repeated must outlive whatever goes wrong beside it.
  void run() {
    asio::post(io_, [this] { tick(); });
    while (!io_.stopped()) {
      try {
        io_.run();
      } catch (const bus::LogNotWritten&) {
        throw;
      } catch (const bus::BusUnavailable&) {
        throw;
      } catch (const ConfigurationError&) {
        throw;
      } catch (const std::exception& error) {
        complain(error.what());
      }
    }
  }

 private:
  static ServerParameters parameters() {
    ServerParameters parameters;
    parameters.content_security_policy = kContentSecurityPolicy;
    return parameters;
  }

  void complain(const char* what) {
    const auto now = steady_clock::now();
    if (complained_ && now - *complained_ < kComplain) return;
    complained_ = now;
    logging::error("{}; the page goes on", what);
  }

  void work() {
    bool goes_on = true;
    try {
      goes_on = work_();
    } catch (...) {
      listen();  // even then: the number of a descriptor that was closed is soon a client's
      throw;
    }
    listen();
    if (goes_on) {
      server_.wake();
    } else {
      io_.stop();
    }
  }

  void tick() {
    timer_.expires_after(kTick);  // first: what throws must not be the last
    timer_.async_wait([this](error_code ended) {
      if (!ended) tick();
    });
    work();
  }

  // A bus has another descriptor after its network was gone, most likely of the same number, and none while it is.
  void listen() {
    const Heard now = heard_();
    if (descriptor_.is_open() && (now.descriptor != descriptor_.native_handle() || now.openings != openings_)) {
      descriptor_.release();
      waiting_ = false;
    }
    if (now.descriptor < 0 || waiting_) return;
    if (!descriptor_.is_open()) descriptor_.assign(now.descriptor);
    openings_ = now.openings;
    waiting_ = true;
    descriptor_.async_wait(asio::posix::stream_descriptor::wait_read, [this, opening = openings_](error_code error) {
      if (error || opening != openings_) return;
      waiting_ = false;
      work();
    });
  }

  const std::function<Heard()>& heard_;
  const std::function<bool()>& work_;
  asio::io_context io_;
  Server server_;
  asio::steady_timer timer_;
  asio::posix::stream_descriptor descriptor_;
  int openings_ = 0;
  bool waiting_ = false;
  std::optional<steady_clock::time_point> complained_;
};

}  // namespace

void serve(SiteNode& site, const ListenPlace& place, const std::function<Heard()>& heard,
           const std::function<bool()>& work) {
  Loop(site, place, heard, work).run();
}

}  // namespace markservo::mmi
