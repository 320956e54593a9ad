#include "services/mmi/web_loop_node.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <chrono>
#include <functional>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>

#include "common/bus/bus_unavailable.hpp"
#include "common/bus/log_not_written.hpp"
#include "common/robot/configuration_error.hpp"
#include "tests/unit/mmi/made_up_source.hpp"
#include "tests/unit/mmi/web_peer.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::mmi {
namespace {

class WebLoop : public ::testing::Test {
 protected:
  void serve(const std::function<bool()>& work) {
    mmi::serve(
        site_, {"", 0, path_}, [this] { return heard_; }, work);
  }
  static bool is_late(std::chrono::steady_clock::time_point begun) {
    return std::chrono::steady_clock::now() - begun > std::chrono::seconds(20);
  }

  test::TemporaryFolder folder_;
  std::string path_ = folder_.file("socket");
  MadeUpSource source_;
  SiteNode site_{source_, "{}", PageFiles(folder_.file("none")), {}};
  Heard heard_;
};

TEST_F(WebLoop, WorksAndServesUntilWorkIsDone) {
  std::optional<WebPeer> peer;
  const auto begun = std::chrono::steady_clock::now();
  serve([&] {
    if (!peer) peer.emplace(path_).get("/state.json");
    peer->receive();
    return peer->received().find("200 OK") == std::string::npos && !is_late(begun);
  });
  EXPECT_NE(peer->received().find("troubles"), std::string::npos);
}

TEST_F(WebLoop, GoesOnWhateverWorkThrows) {
  int worked = 0;
  serve([&]() -> bool {
    switch (++worked) {
      case 1:
        throw std::runtime_error("the first time");
      case 2:
        throw std::bad_alloc();
      case 3:
        throw std::system_error(EIO, std::generic_category());
      default:
        return worked < 6;
    }
  });
  EXPECT_EQ(worked, 6);
}

TEST_F(WebLoop, EndsByWhatMustEndTheProgram) {
  EXPECT_THROW(serve([]() -> bool { throw bus::BusUnavailable("no route"); }), bus::BusUnavailable);
  EXPECT_THROW(serve([]() -> bool { throw bus::LogNotWritten("a.lcm", "full"); }), bus::LogNotWritten);
  EXPECT_THROW(serve([]() -> bool { throw ConfigurationError("wrong"); }), ConfigurationError);
}

// A descriptor in which something waits.
class Pipe {
 public:
  Pipe() {
    if (::pipe2(ends_.data(), O_CLOEXEC) != 0 || ::write(ends_[1], "x", 1) != 1) throw std::runtime_error("no pipe");
  }
  ~Pipe() {
    ::close(ends_[0]);
    ::close(ends_[1]);
  }
  Pipe(const Pipe&) = delete;
  Pipe& operator=(const Pipe&) = delete;
  int readable() const { return ends_[0]; }

 private:
  std::array<int, 2> ends_{};
};

// 1,000 turns take 20 s at the ticks alone, and no time where something waits.
constexpr int kTurns = 1000;

TEST_F(WebLoop, HearsAtOnceWhatWaits) {
  const Pipe pipe;
  heard_ = {pipe.readable(), 1};
  int turns = 0;
  const auto begun = std::chrono::steady_clock::now();
  serve([&] { return ++turns < kTurns && !is_late(begun - std::chrono::seconds(10)); });
  EXPECT_EQ(turns, kTurns);
}

TEST_F(WebLoop, HearsAtOnceByAnotherDescriptorOfTheSameNumber) {
  std::optional<Pipe> pipe(std::in_place);
  heard_ = {pipe->readable(), 1};
  int turns = 0;
  const int number = heard_.descriptor;
  const auto begun = std::chrono::steady_clock::now();
  serve([&] {
    if (++turns == 3) {
      pipe.reset();
      pipe.emplace();
      heard_ = {pipe->readable(), 2};
    }
    return turns < kTurns && !is_late(begun - std::chrono::seconds(10));
  });
  ASSERT_EQ(heard_.descriptor, number);
  EXPECT_EQ(turns, kTurns);
}

TEST_F(WebLoop, HearsNothingByADescriptorThatIsGone) {
  const Pipe pipe;
  heard_ = {pipe.readable(), 1};
  int turns = 0;
  serve([&] {
    if (++turns == 3) heard_ = {-1, 1};
    return turns < 10;
  });
  EXPECT_EQ(turns, 10);
}

}  // namespace
}  // namespace markservo::mmi
