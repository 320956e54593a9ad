#include "common/reflection/message_json.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <limits>
#include <markservo/MarkDetection.hpp>
#include <markservo/ServiceStatus.hpp>
#include <markservo/StereoFrame.hpp>

#include "tests/unit/encoded.hpp"

namespace markservo::reflection {
namespace {

template <class Message>
nlohmann::ordered_json json_of_message(const Message& message, JsonForm form) {
  const auto bytes = test::encoded(message);
  return json_of(decode(TypeCatalog::ours(), bytes.data(), bytes.size()).fields, form);
}

StereoFrame frame_with(const std::string& left) {
  StereoFrame frame{};
  frame.session = std::numeric_limits<std::int64_t>::max();
  frame.seq = 7;
  frame.width = 2;
  frame.left_size = static_cast<std::int32_t>(left.size());
  frame.left.assign(left.begin(), left.end());
  return frame;
}

TEST(MessageJson, HasTheFieldsInTheOrderOfTheType) {
  const auto json = json_of_message(frame_with(""), JsonForm::kShort);
  EXPECT_EQ(json.begin().key(), "utime");
  EXPECT_EQ(json["calibration"]["fx"], 0.0);
}

TEST(MessageJson, TellsBytesByTheirNumberInItsShortForm) {
  const auto json = json_of_message(frame_with("ab"), JsonForm::kShort);
  EXPECT_EQ(json["left"]["bytes"], 2);
  EXPECT_EQ(json["seq"], 7);
}

// RFC 4648, section 10.
TEST(MessageJson, HoldsBytesInBase64InItsExactForm) {
  for (const auto& [bytes, text] : std::vector<std::pair<std::string, std::string>>{
           {"", ""}, {"f", "Zg=="}, {"fo", "Zm8="}, {"foo", "Zm9v"}, {"foob", "Zm9vYg=="}, {"foobar", "Zm9vYmFy"}}) {
    EXPECT_EQ(json_of_message(frame_with(bytes), JsonForm::kExact)["left"], text);
  }
}

TEST(MessageJson, TellsMoreBytesThanAllowedByTheirNumberInItsExactFormToo) {
  MarkDetection detection{};
  detection.num_marks = 1;
  detection.marks.resize(1);
  MarkPatch& patch = detection.marks[0].left.patch;
  patch.bgr_size = 3;
  patch.bgr = {1, 2, 3};
  const auto bytes = test::encoded(detection);
  const Fields fields = decode(TypeCatalog::ours(), bytes.data(), bytes.size()).fields;
  const auto shown = [&](std::size_t most_bytes) {
    return json_of(fields, JsonForm::kExact, most_bytes)["marks"][0]["left"]["patch"]["bgr"];
  };
  EXPECT_EQ(shown(3), "AQID");
  EXPECT_EQ(shown(2), nlohmann::ordered_json({{"bytes", 3}}));
}

TEST(MessageJson, HoldsIntegersOf64BitsAsTextInItsExactFormAndOthersAsNumbers) {
  const auto json = json_of_message(frame_with(""), JsonForm::kExact);
  EXPECT_EQ(json["session"], "9223372036854775807");
  EXPECT_EQ(json["seq"], "7");
  EXPECT_EQ(json["width"], 2);
}

TEST(MessageJson, HoldsTheMessagesWithinAMessageInTheSameForm) {
  ServiceStatus status{};
  status.num_channels = 1;
  status.channels.resize(1);
  status.channels[0].received = 5;
  EXPECT_EQ(json_of_message(status, JsonForm::kExact)["channels"][0]["received"], "5");
  EXPECT_EQ(json_of_message(status, JsonForm::kShort)["channels"][0]["received"], 5);
}

TEST(MessageJson, HoldsNoNumberThatJsonHasNot) {
  StereoFrame frame = frame_with("");
  frame.calibration.fx = std::numeric_limits<double>::quiet_NaN();
  const auto json = json_of_message(frame, JsonForm::kExact);
  EXPECT_NE(json_text(json, -1).find("\"fx\":null"), std::string::npos);
}

}  // namespace
}  // namespace markservo::reflection
