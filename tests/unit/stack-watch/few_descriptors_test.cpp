// The watch without descriptors: it says so, and takes nobody for dead.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <thread>

#include "services/stack-watch/answering_device.hpp"
#include "services/stack-watch/supervisor/supervisor_reader.hpp"

namespace markservo::stack_watch {
namespace {

// While it lives this process gets no new descriptor.
class NoDescriptors {
 public:
  // `most`: those below may be open; 0 to 2 are.
  explicit NoDescriptors(rlim_t most) {
    getrlimit(RLIMIT_NOFILE, &before_);
    const rlimit none{most, before_.rlim_max};
    setrlimit(RLIMIT_NOFILE, &none);
  }
  ~NoDescriptors() { setrlimit(RLIMIT_NOFILE, &before_); }
  NoDescriptors(const NoDescriptors&) = delete;
  NoDescriptors& operator=(const NoDescriptors&) = delete;

 private:
  rlimit before_{};
};

double cpu_s() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::string socket_path() {
  return testing::TempDir() + "watch-" + std::to_string(getpid()) + ".sock";
}

TEST(FewDescriptors, AreNotTakenForADeadSupervisor) {
  const NoDescriptors none(3);
  EXPECT_THROW(ask_supervisor("/nowhere/supervisor.sock"), CannotAsk);
}

TEST(FewDescriptors, ASupervisorThatDoesNotAnswerIsSilent) {
  EXPECT_THROW(ask_supervisor("/nowhere/supervisor.sock"), SupervisorSilent);
}

TEST(FewDescriptors, WhoeverAsksMeanwhileIsAnsweredAfterwardsAndCostsNothing) {
  const std::string path = socket_path();
  const AnsweringDevice device(path, [] { return std::string("{}"); });
  const int asking = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path, path.c_str(), path.size());
  for (const rlim_t most : {rlim_t{3}, rlim_t{0}}) {
    const NoDescriptors none(most);
    if (most == 3) {
      ASSERT_EQ(connect(asking, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    }
    const double before = cpu_s();
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    EXPECT_LT(cpu_s() - before, 0.1) << most;
  }
  char text[2] = {};
  EXPECT_EQ(recv(asking, text, sizeof text, MSG_WAITALL), 2);
  close(asking);
}

}  // namespace
}  // namespace markservo::stack_watch
