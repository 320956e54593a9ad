#include "common/bus/reachability.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <string>
#include <thread>

#include "common/bus/bus.hpp"
#include "common/bus/connection.hpp"
#include "tests/unit/bus/memq_bus.hpp"

namespace markservo::bus {
namespace {

using Kind = Reachability::Kind;

TEST(Reachability, LeavesOtherBusesToLiblcm) {
  EXPECT_EQ(reach("memq://", true).kind, Kind::kReachable);
  EXPECT_EQ(reach("file:///nowhere/no.lcm", true).kind, Kind::kReachable);
}

TEST(Reachability, WrongAddressIsNeverReachable) {
  for (const char* url : {"udpm://10.0.0.1:7667", "udpm://nowhere:7667", "udpm://239.255.76.67:sixty",
                          "udpm://239.255.76.67:70000", "tcpq://127.0.0.1:x"}) {
    const Reachability found = reach(url, true);
    EXPECT_EQ(found.kind, Kind::kNever) << url;
    EXPECT_NE(found.reason.find("allowed"), std::string::npos) << found.reason;
  }
}

// liblcm aborts the process.
TEST(Reachability, ServerThatIsMissingIsToldInOneLine) {
  const std::string url = "tcpq://127.0.0.1:1";
  EXPECT_EQ(reach(url, true).kind, Kind::kMissing);
  BusParameters parameters = memq_parameters("test");
  parameters.urls = {url, url};
  try {
    Bus bus(parameters);
    FAIL() << "joined";
  } catch (const BusUnavailable& error) {
    const std::string what = error.what();
    EXPECT_NE(what.find("no LCM server at 127.0.0.1:1 (Connection refused)"), std::string::npos) << what;
    EXPECT_EQ(what.find('\n'), std::string::npos);
  }
}

// A server whose queue of callers is full: the kernel drops what others send to connect, as a firewall does.
class SilentServer {
 public:
  SilentServer() {
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    auto* raw = reinterpret_cast<sockaddr*>(&address);
    listening_ = socket(AF_INET, SOCK_STREAM, 0);
    bind(listening_, raw, size);
    listen(listening_, 0);
    getsockname(listening_, raw, &size);
    port_ = ntohs(address.sin_port);
    for (int& caller : callers_) {
      caller = socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK, 0);
      connect(caller, raw, size);
    }
  }
  ~SilentServer() {
    for (const int caller : callers_) close(caller);
    close(listening_);
  }
  SilentServer(const SilentServer&) = delete;
  SilentServer& operator=(const SilentServer&) = delete;
  std::string url() const { return "tcpq://127.0.0.1:" + std::to_string(port_); }

 private:
  int listening_ = -1;
  int port_ = 0;
  std::array<int, 4> callers_{};
};

TEST(Reachability, ServerThatDoesNotAnswerIsNotWaitedForLong) {
  const SilentServer server;
  const auto begin = std::chrono::steady_clock::now();
  const Reachability found = reach(server.url(), true);
  EXPECT_EQ(found.kind, Kind::kMissing) << found.reason;
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(2));
}

TEST(Connection, IsNotKeptFromItsWorkByAServerThatDoesNotAnswer) {
  const SilentServer server;
  Connection connection(server.url(), nullptr);
  EXPECT_FALSE(connection.open());
  const auto begin = std::chrono::steady_clock::now();
  const std::chrono::milliseconds span(3000);
  std::chrono::steady_clock::duration kept{};
  while (std::chrono::steady_clock::now() - begin < span) {
    const auto now = std::chrono::steady_clock::now();
    connection.mend(now);
    EXPECT_FALSE(connection.publish({"STOP", "x", 1, 0}, now));
    kept += std::chrono::steady_clock::now() - now;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  EXPECT_LT(kept, span / 2);
}

class WithoutDescriptors : public ::testing::Test {
 protected:
  WithoutDescriptors() {
    getrlimit(RLIMIT_NOFILE, &before_);
    const int next = open("/dev/null", O_RDONLY);
    close(next);
    rlimit scarce = before_;
    scarce.rlim_cur = static_cast<rlim_t>(next) + kFree;
    setrlimit(RLIMIT_NOFILE, &scarce);
  }
  ~WithoutDescriptors() override { setrlimit(RLIMIT_NOFILE, &before_); }

  static constexpr rlim_t kFree = 4;
  rlimit before_{};
};

TEST_F(WithoutDescriptors, BusIsNeverReachable) {
  for (const char* url : {"udpm://239.255.76.67:7667?ttl=0", "tcpq://127.0.0.1:7700"}) {
    const Reachability found = reach(url, true);
    EXPECT_EQ(found.kind, Kind::kNever) << url;
    EXPECT_NE(found.reason.find("ulimit -n"), std::string::npos) << found.reason;
  }
}

}  // namespace
}  // namespace markservo::bus
