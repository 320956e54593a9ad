#include "services/stack-watch/lcm_datagram.hpp"

#include <gtest/gtest.h>

namespace markservo::stack_watch {
namespace {

using Bytes = std::vector<std::uint8_t>;

struct Fragment {
  std::uint32_t message_size = 700;
  std::uint32_t offset = 0;
  std::uint8_t number = 0;
  std::size_t part = 100;  // bytes of payload
};

Bytes bytes_of(const Fragment& fragment) {
  Bytes bytes{'L', 'C', '0', '3', 0, 0, 0, 1};
  for (const std::uint32_t value : {fragment.message_size, fragment.offset}) {
    for (const int shift : {24, 16, 8, 0}) bytes.push_back(static_cast<std::uint8_t>(value >> shift));
  }
  bytes.insert(bytes.end(), {0, fragment.number, 0, 2});
  if (fragment.number == 0) bytes.insert(bytes.end(), {'P', 'O', 'S', 'E', 0});
  bytes.resize(bytes.size() + fragment.part, 0x5a);
  return bytes;
}

bool crafted(const Fragment& fragment) {
  const Bytes bytes = bytes_of(fragment);
  return is_crafted(bytes.data(), bytes.size(), bytes.size());
}

TEST(LcmDatagram, ReadsTheShortMessageThatItWrites) {
  const Bytes bytes = short_message(5, "STOP", {1, 2, 3});
  const auto read = read_datagram(bytes.data(), bytes.size());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->channel, "STOP");
  EXPECT_EQ(Bytes(read->payload, read->payload + read->size), (Bytes{1, 2, 3}));
  EXPECT_TRUE(read->whole);
}

TEST(LcmDatagram, ReadsTheBeginningOfALongMessage) {
  const Bytes bytes = bytes_of({});
  const auto read = read_datagram(bytes.data(), bytes.size());
  ASSERT_TRUE(read);
  EXPECT_EQ(read->channel, "POSE");
  EXPECT_EQ(read->size, 100U);
  EXPECT_EQ(read->message_size, 700U);
  EXPECT_FALSE(read->whole);
}

TEST(LcmDatagram, FindsNothingInLaterFragmentsAndInOtherBytes) {
  const Bytes later = bytes_of({700, 100, 1});
  EXPECT_FALSE(read_datagram(later.data(), later.size()));
  const Bytes other(100, 0x4c);
  EXPECT_FALSE(read_datagram(other.data(), other.size()));
}

TEST(LcmDatagram, ReadsNothingBeyondBytesThatEndTooSoon) {
  for (const Bytes& whole : {short_message(5, "STOP", {}), bytes_of({})}) {
    for (std::size_t size = 0; size < 12; ++size) {
      const Bytes bytes(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size));  // the end of its memory
      EXPECT_FALSE(read_datagram(bytes.data(), bytes.size())) << size;
      EXPECT_FALSE(is_crafted(bytes.data(), bytes.size(), bytes.size())) << size;
    }
  }
}

TEST(LcmDatagram, RefusesAChannelThatIsTooLongOrHasNoEnd) {
  const Bytes longest = short_message(5, std::string(63, 'x'), {});
  EXPECT_TRUE(read_datagram(longest.data(), longest.size()));
  const Bytes longer = short_message(5, std::string(64, 'x'), {});
  EXPECT_FALSE(read_datagram(longer.data(), longer.size()));
  const Bytes endless{'L', 'C', '0', '2', 0, 0, 0, 1, 'x', 'y'};
  EXPECT_FALSE(read_datagram(endless.data(), endless.size()));
}

TEST(LcmDatagram, KnowsAFragmentOutsideOfItsMessage) {
  EXPECT_FALSE(crafted({700, 0, 0, 100}));
  EXPECT_FALSE(crafted({700, 600, 1, 100}));
  EXPECT_TRUE(crafted({700, 601, 1, 100}));
  EXPECT_TRUE(crafted({700, 0xffffff00, 1, 700})) << "offset and size together are 444, in 32 bits";
}

TEST(LcmDatagram, KnowsAFirstFragmentWithoutAChannel) {
  Bytes bytes = bytes_of({});
  bytes.resize(20);
  EXPECT_TRUE(is_crafted(bytes.data(), bytes.size(), bytes.size()));
}

}  // namespace
}  // namespace markservo::stack_watch
