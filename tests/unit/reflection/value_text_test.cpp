#include "common/reflection/value_text.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <markservo/StereoFrame.hpp>

#include "tests/unit/encoded.hpp"

namespace markservo::reflection {
namespace {

TEST(ValueText, WritesNumbersThatReadBackToTheSameValue) {
  EXPECT_EQ(text_of({0.1}), "0.1");
  EXPECT_EQ(text_of({1.0 / 3.0}), "0.3333333333333333");
  EXPECT_EQ(text_of({std::numeric_limits<double>::quiet_NaN()}), "nan");
  EXPECT_EQ(text_of({std::numeric_limits<std::int64_t>::min()}), "-9223372036854775808");
  EXPECT_EQ(text_of({true}), "true");
  EXPECT_EQ(text_of({std::string("a,b")}), "a,b");
}

TEST(ValueText, TellsBytesByTheirNumber) {
  StereoFrame frame{};
  frame.left_size = 2;
  frame.left = {7, 8};
  const auto bytes = test::encoded(frame);
  const DecodedMessage message = decode(TypeCatalog::ours(), bytes.data(), bytes.size());
  ASSERT_EQ(message.error, "");
  EXPECT_EQ(text_of(*message.fields.find("left")), "2 bytes");
}

}  // namespace
}  // namespace markservo::reflection
