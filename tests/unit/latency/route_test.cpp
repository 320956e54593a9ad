#include "tests/bench/latency/route.hpp"

#include <gtest/gtest.h>

#include <markservo/JointCommand.hpp>
#include <stdexcept>

namespace markservo::bench {
namespace {

TEST(Route, the_next_port_keeps_the_rest_of_the_url) {
  EXPECT_EQ(next_port("udpm://239.255.76.67:7667?ttl=0&recv_buf_size=4194304"),
            "udpm://239.255.76.67:7668?ttl=0&recv_buf_size=4194304");
  EXPECT_EQ(next_port("udpm://239.255.76.67:65534"), "udpm://239.255.76.67:65535");
}

TEST(Route, refuses_a_url_without_a_port_that_has_a_next) {
  for (const char* url : {"memq://", "udpm://", "udpm://239.255.76.67", "udpm://239.255.76.67:?ttl=0",
                          "udpm://239.255.76.67:65535", "udpm://239.255.76.67:0", "udpm://239.255.76.67:7667766766"}) {
    EXPECT_THROW(next_port(url), std::invalid_argument) << url;
  }
}

TEST(Route, the_chains_answer_names_its_frame) {
  JointCommand command{};
  command.frame_seq = 42;
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(command.getEncodedSize()));
  command.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  const Stage answer = chain_route("udpm://239.255.76.67:7667").stages.back();
  EXPECT_EQ(answer.frame_of(bytes.data(), bytes.size()), 42);
  EXPECT_EQ(answer.frame_of(bytes.data(), bytes.size() - 1), std::nullopt);
}

TEST(Route, a_stamped_frame_names_itself_to_empty_processes) {
  const Route floor = floor_route("udpm://239.255.76.67:7668");
  std::vector<std::uint8_t> frame(16);
  floor.stamp(frame, 42);
  EXPECT_EQ(floor.stages.front().frame_of(frame.data(), frame.size()), 42);
  EXPECT_EQ(floor.stages.front().frame_of(frame.data(), 7), std::nullopt);
}

}  // namespace
}  // namespace markservo::bench
