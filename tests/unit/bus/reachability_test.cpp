#include "common/bus/reachability.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <string>

#include "common/bus/bus.hpp"
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
