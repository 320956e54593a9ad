#include "tests/system/fault_campaign/message_leaves.hpp"

#include <gtest/gtest.h>

#include <markservo/JointState.hpp>
#include <markservo/SimTruth.hpp>
#include <markservo/StopRequest.hpp>

#include "common/bus/safe_decode.hpp"

namespace markservo::campaign {
namespace {

template <class M>
Bytes encode(const M& message) {
  Bytes bytes(static_cast<std::size_t>(message.getEncodedSize()));
  message.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  return bytes;
}

const LeafSpan& leaf(const std::vector<LeafSpan>& leaves, const std::string& path) {
  for (const LeafSpan& one : leaves) {
    if (one.path == path) return one;
  }
  throw std::out_of_range(path);
}

TEST(MessageLeaves, AnyNumberCanBeSet) {
  JointState state{};
  state.session = 5;
  state.num_joints = 2;
  state.position = {0.1, 0.2};
  state.speed = {0.3, 0.4};
  Bytes bytes = encode(state);
  const auto leaves = leaf_spans(reflection::TypeCatalog::ours(), bytes);
  EXPECT_EQ(integer_at(bytes, leaf(leaves, "session")), 5);
  EXPECT_TRUE(leaf(leaves, "num_joints").length);
  put_integer(bytes, leaf(leaves, "session"), -9);
  put_real(bytes, leaf(leaves, "position[1]"), -7.5);
  const auto decoded = bus::safe_decode<JointState>(bytes.data(), bytes.size());
  ASSERT_TRUE(decoded.ok) << decoded.error;
  EXPECT_EQ(decoded.message.session, -9);
  EXPECT_EQ(decoded.message.position[1], -7.5);
  EXPECT_EQ(decoded.message.speed[0], 0.3);
}

TEST(MessageLeaves, ATextCanBeReplacedByALongerOne) {
  StopRequest request{};
  request.source = "someone";
  request.reason = "because";
  Bytes bytes = encode(request);
  put_text(bytes, leaf(leaf_spans(reflection::TypeCatalog::ours(), bytes), "source"), std::string(1000, 'x'));
  const auto decoded = bus::safe_decode<StopRequest>(bytes.data(), bytes.size());
  ASSERT_TRUE(decoded.ok) << decoded.error;
  EXPECT_EQ(decoded.message.source.size(), 1000U);
  EXPECT_EQ(decoded.message.reason, "because");
}

TEST(MessageLeaves, NestedMessagesHaveTheirs) {
  SimTruth truth{};
  truth.num_bodies = 2;
  truth.bodies.resize(2);
  truth.bodies[1].p_CB.y = 3.0;
  Bytes bytes = encode(truth);
  const auto leaves = leaf_spans(reflection::TypeCatalog::ours(), bytes);
  EXPECT_EQ(real_at(bytes, leaf(leaves, "bodies[1].p_CB.y")), 3.0);
}

TEST(MessageLeaves, OtherBytesHaveNone) {
  EXPECT_TRUE(leaf_spans(reflection::TypeCatalog::ours(), {1, 2, 3}).empty());
}

}  // namespace
}  // namespace markservo::campaign
