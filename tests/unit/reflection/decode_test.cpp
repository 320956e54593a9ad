#include <gtest/gtest.h>

#include <cmath>
#include <markservo/MarkDetection.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/TargetPose.hpp>
#include <random>

#include "common/bus/safe_decode.hpp"
#include "common/reflection/lcm_language.hpp"
#include "common/reflection/message_value.hpp"
#include "common/reflection/value_text.hpp"
#include "tests/unit/encoded.hpp"

namespace markservo::reflection {
namespace {

using test::encoded;

ServiceStatus status() {
  ServiceStatus status{};
  status.utime = 1'700'000'000'123'456;
  status.session = -5;
  status.name = "a name";
  status.state = "ready";
  status.num_channels = 2;
  status.channels.resize(2);
  status.channels[1].channel = "X";
  status.channels[1].second_writer = 1;
  status.channels[1].age = 0.1;
  status.channels[1].latency_p99 = -1e-300;
  return status;
}

StereoFrame frame() {
  StereoFrame frame{};
  frame.width = 3;
  frame.calibration.fx = 700.5;
  frame.left_size = 4;
  frame.left = {1, 2, 3, 255};
  return frame;
}

TEST(Decode, GivesEveryFieldItsNameAndItsValue) {
  const auto bytes = encoded(status());
  const DecodedMessage message = decode(TypeCatalog::ours(), bytes.data(), bytes.size());
  ASSERT_EQ(message.error, "");
  EXPECT_EQ(message.fields.type->full_name(), "markservo.ServiceStatus");
  std::map<std::string, std::string> texts;
  for (const Leaf& leaf : leaves(message.fields)) texts[leaf.path] = text_of(leaf.value);
  EXPECT_EQ(texts.at("utime"), "1700000000123456");
  EXPECT_EQ(texts.at("session"), "-5");
  EXPECT_EQ(texts.at("name"), "a name");
  EXPECT_EQ(texts.at("channels[1].second_writer"), "true");
  EXPECT_EQ(texts.at("channels[1].age"), "0.1");
  EXPECT_EQ(texts.at("channels[1].latency_p99"), "-1e-300");
  EXPECT_EQ(texts.count("channels[2].channel"), 0U);
  EXPECT_EQ(integer_in(message.fields, "num_channels", -1), 2);
  EXPECT_EQ(integer_in(message.fields, "name", -1), -1);
  EXPECT_EQ(integer_in(message.fields, "absent", -7), -7);
}

TEST(Decode, LeavesBytesWhereTheyAre) {
  const auto bytes = encoded(frame());
  const DecodedMessage message = decode(TypeCatalog::ours(), bytes.data(), bytes.size());
  ASSERT_EQ(message.error, "");
  const auto& left = std::get<Bytes>(message.fields.find("left")->content);
  EXPECT_EQ(left.size, 4U);
  EXPECT_EQ(left.data[3], 255);
  EXPECT_GE(left.data, bytes.data());
  EXPECT_LT(left.data, bytes.data() + bytes.size());
}

TEST(Decode, SaysWhyBytesAreNoMessage) {
  const auto error = [](const std::vector<std::uint8_t>& bytes) {
    return decode(TypeCatalog::ours(), bytes.data(), bytes.size()).error;
  };
  EXPECT_EQ(error({}), "message of 0 bytes is shorter than a type's fingerprint");
  EXPECT_EQ(error({0, 0, 0, 0, 0, 0, 0, 1}), "unknown type 0x0000000000000001");
  auto bytes = encoded(TargetPose{});
  bytes.push_back(0);
  EXPECT_EQ(error(bytes), "TargetPose has 1 bytes too many");
  bytes.resize(bytes.size() - 2);
  EXPECT_EQ(error(bytes), "TargetPose is truncated");
  bytes = encoded(TargetPose{});
  bytes[bytes.size() - 4] = 0xff;
  EXPECT_EQ(error(bytes), "TargetPose has -16777216 elements in marks");
}

// The generated code, hardened, is the reference: whatever happens to the bytes, both take them or neither does.
template <class M>
void expect_the_same_judgement(const M& message, unsigned seed) {
  std::mt19937 random(seed);
  const auto whole = encoded(message);
  int refused = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    auto bytes = whole;
    for (auto changes = 1 + random() % 3; changes > 0; --changes) {
      bytes[8 + random() % (bytes.size() - 8)] = static_cast<std::uint8_t>(random() % 3 == 0 ? 0 : random());
    }
    if (random() % 4 == 0) bytes.resize(8 + random() % (bytes.size() - 8));
    const std::string theirs = bus::safe_decode<M>(bytes.data(), bytes.size()).error;
    const std::string ours = decode(TypeCatalog::ours(), bytes.data(), bytes.size()).error;
    refused += theirs.empty() ? 0 : 1;
    ASSERT_EQ(theirs.empty(), ours.empty()) << "trial " << trial << ": generated: " << theirs << "; ours: " << ours;
  }
  EXPECT_GT(refused, 300);
}

TEST(Decode, TakesAndRefusesWhatTheGeneratedCodeDoes) {
  expect_the_same_judgement(status(), 1);
  expect_the_same_judgement(frame(), 2);
  TargetPose pose{};
  pose.num_marks = 3;
  pose.marks.resize(3);
  expect_the_same_judgement(pose, 3);
  MarkDetection detection{};
  detection.num_marks = 2;
  detection.marks.resize(2);
  expect_the_same_judgement(detection, 4);
}

TEST(Decode, TakesNoMemoryThatTheBytesDoNotJustify) {
  const TypeCatalog catalog(
      parse_types("struct nothing { } struct s { int32_t n; nothing x[n]; } struct t { int32_t n; t x[n]; }", "test"));
  const auto message = [&catalog](const char* name, std::uint32_t elements, std::size_t more) {
    std::vector<std::uint8_t> bytes;
    for (int i = 7; i >= 0; --i) bytes.push_back(static_cast<std::uint8_t>(catalog.find(name)->fingerprint >> 8 * i));
    for (int i = 3; i >= 0; --i) bytes.push_back(static_cast<std::uint8_t>(elements >> 8 * i));
    bytes.resize(bytes.size() + more, 1);
    return decode(catalog, bytes.data(), bytes.size()).error;
  };
  EXPECT_EQ(message("s", 0x7fffffff, 0), "s has 2147483647 elements in x");
  std::vector<std::uint8_t> deep;
  for (int i = 7; i >= 0; --i) deep.push_back(static_cast<std::uint8_t>(catalog.find("t")->fingerprint >> 8 * i));
  for (int i = 0; i < 1000; ++i) deep.insert(deep.end(), {0, 0, 0, 1});
  EXPECT_EQ(decode(catalog, deep.data(), deep.size()).error, "t nests more than 32 types");
}

}  // namespace
}  // namespace markservo::reflection
