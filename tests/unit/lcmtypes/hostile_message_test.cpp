// Whatever bytes arrive, decoding ends with a message or a reason: no exception, no large allocation.

#include <cstdint>
#include <cstdio>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "common/bus/safe_decode.hpp"
#include "common/text/text.hpp"
#include "tests/unit/lcmtypes/all_types.hpp"

namespace markservo {
namespace {

template <class M>
std::vector<std::uint8_t> encoded_default() {
  M message{};
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(message.getEncodedSize()));
  EXPECT_EQ(message.encode(bytes.data(), 0, static_cast<int>(bytes.size())), static_cast<int>(bytes.size()));
  return bytes;
}

template <class M>
class EveryType : public ::testing::Test {};
TYPED_TEST_SUITE(EveryType, AllTypes);

TYPED_TEST(EveryType, SurvivesEncodingAndDecoding) {
  const auto bytes = encoded_default<TypeParam>();
  EXPECT_TRUE(bus::safe_decode<TypeParam>(bytes.data(), bytes.size()).ok);
}

TYPED_TEST(EveryType, IsRefusedWhenTruncatedAnywhere) {
  const auto bytes = encoded_default<TypeParam>();
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_FALSE(bus::safe_decode<TypeParam>(bytes.data(), size).ok) << "after " << size << " bytes";
  }
}

TYPED_TEST(EveryType, NamesBothFingerprintsWhenItIsOfAnotherVersion) {
  auto bytes = encoded_default<TypeParam>();
  bytes[7] ^= 1;
  const std::string why = bus::safe_decode<TypeParam>(bytes.data(), bytes.size()).error;
  char ours[32];
  char theirs[32];
  const auto hash = static_cast<std::uint64_t>(TypeParam::getHash());
  std::snprintf(ours, sizeof ours, "0x%016llx", static_cast<unsigned long long>(hash));
  std::snprintf(theirs, sizeof theirs, "0x%016llx", static_cast<unsigned long long>(hash ^ 1));
  EXPECT_EQ(why, std::string("message is of another version of ") + TypeParam::getTypeName() +
                     " or of another type: its fingerprint is " + theirs + ", here it is " + ours);
  EXPECT_LE(why.size(), text::kMaxBytes - 50) << "as a reason in SERVICE_STATUS, behind the channel's name";
}

TYPED_TEST(EveryType, IsRefusedWithBytesBehindIt) {
  auto bytes = encoded_default<TypeParam>();
  bytes.push_back(0);
  EXPECT_FALSE(bus::safe_decode<TypeParam>(bytes.data(), bytes.size()).ok);
}

// Any aligned or unaligned place may hold a length: negative, zero, 2 billion, and those whose byte count wraps an int.
TYPED_TEST(EveryType, SurvivesExtremeNumbersAnywhere) {
  const auto intact = encoded_default<TypeParam>();
  for (const std::int32_t extreme : {-1, 0, 2000000000, INT32_MIN, INT32_MAX, 1 << 29, 1 << 30}) {
    for (std::size_t at = 8; at + 4 <= intact.size(); ++at) {
      auto bytes = intact;
      const std::uint32_t big_endian = __builtin_bswap32(static_cast<std::uint32_t>(extreme));
      std::memcpy(&bytes[at], &big_endian, sizeof big_endian);
      EXPECT_NO_THROW(bus::safe_decode<TypeParam>(bytes.data(), bytes.size()));
    }
  }
}

TYPED_TEST(EveryType, SurvivesRandomBytesBehindItsFingerprint) {
  const auto intact = encoded_default<TypeParam>();
  std::mt19937 random(1);
  for (int trial = 0; trial < 2000; ++trial) {
    std::vector<std::uint8_t> bytes(8 + random() % 600);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random() % 4 == 0 ? random() : 0);
    std::memcpy(bytes.data(), intact.data(), 8);
    EXPECT_NO_THROW(bus::safe_decode<TypeParam>(bytes.data(), bytes.size()));
  }
}

TEST(HostileMessage, OfAnotherTypeIsNamed) {
  const auto bytes = encoded_default<StopState>();
  const auto decoded = bus::safe_decode<JointState>(bytes.data(), bytes.size());
  EXPECT_FALSE(decoded.ok);
  EXPECT_NE(decoded.error.find("JointState"), std::string::npos);
}

TEST(HostileMessage, NegativeLengthIsRefused) {
  auto bytes = encoded_default<JointState>();
  const std::uint32_t minus_one = 0xffffffff;
  std::memcpy(&bytes[8 + 24], &minus_one, 4);  // num_joints follows the fingerprint, utime, session and seq
  EXPECT_FALSE(bus::safe_decode<JointState>(bytes.data(), bytes.size()).ok);
}

TEST(HostileMessage, StringOfLengthZeroIsRefused) {
  auto bytes = encoded_default<StopState>();
  std::memset(&bytes[8 + 24], 0, 4);  // the length of `device`
  EXPECT_FALSE(bus::safe_decode<StopState>(bytes.data(), bytes.size()).ok);
}

TEST(HostileMessage, StringWithAZeroInsideOrNoneAtItsEndIsRefused) {
  StopState state{};
  state.device = "arm";
  std::vector<std::uint8_t> intact(static_cast<std::size_t>(state.getEncodedSize()));
  ASSERT_GT(state.encode(intact.data(), 0, static_cast<int>(intact.size())), 0);
  const std::size_t device = 8 + 24 + 4;  // behind the fingerprint, utime, session, seq and its own length
  ASSERT_EQ(intact[device], 'a');
  auto bytes = intact;
  bytes[device + 1] = 0;
  EXPECT_FALSE(bus::safe_decode<StopState>(bytes.data(), bytes.size()).ok);
  bytes = intact;
  bytes[device + 3] = 'm';
  EXPECT_FALSE(bus::safe_decode<StopState>(bytes.data(), bytes.size()).ok);
}

TEST(CarelessMessage, WhoseLengthFieldExceedsItsVectorIsNotEncoded) {
  JointState state{};
  state.num_joints = 3;  // no positions
  std::vector<std::uint8_t> bytes(1000);
  EXPECT_LT(state.encode(bytes.data(), 0, 1000), 0);

  TargetPose pose{};
  pose.num_marks = 2;
  EXPECT_NO_THROW(pose.getEncodedSize());
  EXPECT_LT(pose.encode(bytes.data(), 0, 1000), 0);
}

TEST(DecodingIntoAUsedMessage, LeavesNothingOfTheOther) {
  JointState joints{};
  joints.num_joints = 3;
  joints.position.assign(3, 1.0);
  joints.speed.assign(3, 1.0);
  const auto without_joints = encoded_default<JointState>();
  EXPECT_EQ(bus::decode_into(joints, without_joints.data(), without_joints.size()), "");
  EXPECT_TRUE(joints.position.empty());
  EXPECT_TRUE(joints.speed.empty());

  TargetPose pose{};
  pose.num_marks = 2;
  pose.marks.resize(2);
  const auto without_marks = encoded_default<TargetPose>();
  EXPECT_EQ(bus::decode_into(pose, without_marks.data(), without_marks.size()), "");
  EXPECT_TRUE(pose.marks.empty());
}

TEST(DecodingIntoAUsedMessage, UsesItsMemory) {
  StereoFrame frame{};
  frame.left_size = 1000;
  frame.left.assign(1000, 7);
  std::vector<std::uint8_t> bytes(static_cast<std::size_t>(frame.getEncodedSize()));
  frame.encode(bytes.data(), 0, static_cast<int>(bytes.size()));
  frame.left.assign(1000, 0);
  const std::uint8_t* const memory = frame.left.data();
  EXPECT_EQ(bus::decode_into(frame, bytes.data(), bytes.size()), "");
  EXPECT_EQ(frame.left, std::vector<std::uint8_t>(1000, 7));
  EXPECT_EQ(frame.left.data(), memory);
}

}  // namespace
}  // namespace markservo
