#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <boost/asio/local/stream_protocol.hpp>
#include <chrono>

#include "common/robot/configuration_error.hpp"
#include "tests/unit/mmi/web_server.hpp"

namespace markservo::mmi {
namespace {

bool exists(const std::string& path) {
  struct stat found {};
  return ::stat(path.c_str(), &found) == 0;
}

int bind_to(int socket, const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  return ::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address);
}

TEST_F(WebServer, ListensForItsOwnerAlone) {
  struct stat found {};
  ASSERT_EQ(::stat(path_.c_str(), &found), 0);
  EXPECT_EQ(found.st_mode & 0077U, 0U);
}

TEST_F(WebServer, ListensNowhereTwice) {
  EXPECT_THROW(Server(io_, ListenPlace{"", 0, path_}, parameters_, site_), ConfigurationError);
  EXPECT_THROW(Server(io_, ListenPlace{"", 0, folder_.write("file", "")}, parameters_, site_), ConfigurationError);
  EXPECT_THROW(Server(io_, ListenPlace{"", 0, folder_.file("none/socket")}, parameters_, site_), ConfigurationError);
}

TEST_F(WebServer, TakesNoSocketOfWhichItDoesNotKnowWhetherItIsDead) {
  const std::string datagrams = folder_.file("datagrams");
  const int other = ::socket(AF_UNIX, SOCK_DGRAM, 0);
  ASSERT_EQ(bind_to(other, datagrams), 0);
  try {
    const Server server(io_, ListenPlace{"", 0, datagrams}, parameters_, site_);
    ADD_FAILURE() << "it was taken";
  } catch (const ConfigurationError& error) {
    EXPECT_NE(std::string(error.what()).find("whether it is in use"), std::string::npos) << error.what();
  }
  EXPECT_TRUE(exists(datagrams));
  ::close(other);
}

TEST_F(WebServer, WaitsForNoListenerThatIsBusy) {
  const std::string busy = folder_.file("busy");
  const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind_to(listener, busy), 0);
  ASSERT_EQ(::listen(listener, 0), 0);
  const WebPeer first(busy);
  ASSERT_THROW(WebPeer{busy}, std::runtime_error);  // its queue is full
  EXPECT_THROW(Server(io_, ListenPlace{"", 0, busy}, parameters_, site_), ConfigurationError);
  EXPECT_TRUE(exists(busy));
  ::close(listener);
}

TEST_F(WebServer, TakesThePlaceOfOneThatWasKilled) {
  const std::string left = folder_.file("left");
  { boost::asio::local::stream_protocol::acceptor dead(io_, boost::asio::local::stream_protocol::endpoint(left)); }
  const Server server(io_, ListenPlace{"", 0, left}, parameters_, site_);
  EXPECT_NO_THROW(WebPeer{left});
}

TEST_F(WebServer, LeavesNothingWhenItEnds) {
  WebPeer& one = peer();
  one.open_socket();
  ASSERT_TRUE(answers(one, "101"));
  server_.reset();
  EXPECT_FALSE(exists(path_));
  io_.restart();
  io_.run_for(std::chrono::milliseconds(10));
  one.receive();
  EXPECT_TRUE(one.ended());
}

TEST_F(WebServer, LeavesASocketThatIsAnothersByThen) {
  ::unlink(path_.c_str());
  const int other = ::socket(AF_UNIX, SOCK_STREAM, 0);
  ASSERT_EQ(bind_to(other, path_), 0);
  server_.reset();
  EXPECT_TRUE(exists(path_));
  ::close(other);
}

TEST_F(WebServer, TakesClientsAgainOnceThereAreDescriptors) {
  WebPeer& one = peer();
  one.get("/");
  rlimit before{};
  ASSERT_EQ(::getrlimit(RLIMIT_NOFILE, &before), 0);
  const rlimit none{0, before.rlim_max};
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &none), 0);
  io_.restart();
  io_.run_for(std::chrono::milliseconds(150));
  one.receive();
  EXPECT_EQ(one.received(), "");
  EXPECT_EQ(server_->connections(), 0);
  ASSERT_EQ(::setrlimit(RLIMIT_NOFILE, &before), 0);
  EXPECT_TRUE(answers(one, "hello"));
}

}  // namespace
}  // namespace markservo::mmi
