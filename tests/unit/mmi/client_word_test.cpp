#include "services/mmi/server/client_word.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace markservo::mmi {
namespace {

template <class M>
M parsed(std::string_view text) {
  return std::get<M>(parse_client_word(text));
}

std::string objection(std::string_view text) {
  try {
    parse_client_word(text);
    return {};
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
}

TEST(ClientWord, SaysWhatItSays) {
  EXPECT_EQ(parsed<ClientHello>(R"({"type":"hello","protocol":1,"token":"abc"})").token, "abc");
  EXPECT_TRUE(parsed<ClientPictures>(R"({"type":"pictures","on":true})").on);
  EXPECT_EQ(parsed<ClientSeen>(R"({"type":"seen","number":7})").picture, 7);
  EXPECT_EQ(parsed<ClientTook>(R"({"type":"took","number":8})").update, 8);
  EXPECT_EQ(parsed<ClientLook>(R"({"type":"look","channels":["A","B"]})").channels,
            (std::vector<std::string>{"A", "B"}));
  EXPECT_EQ(parsed<ClientStop>(R"({"type":"stop","reason":"smoke"})").reason, "smoke");
  EXPECT_EQ(parsed<ClientPlay>(R"({"type":"play","speed":2.5})").speed, 2.5);
  EXPECT_EQ(parsed<ClientSeek>(R"({"type":"seek","utime":"1796077861504223"})").utime, 1796077861504223);
  EXPECT_EQ(parsed<ClientStep>(R"({"type":"step","by":-1})").frames, -1);
  EXPECT_TRUE(std::holds_alternative<ClientPause>(parse_client_word(R"({"type":"pause"})")));
}

TEST(ClientWord, Commands) {
  const auto command = parsed<ClientCommand>(
      R"({"type":"command","session":"9007199254740993","seq":2,"expires":"5","kind":"carry","target":"red_book"})");
  EXPECT_EQ(command.stamp.session, 9007199254740993);
  EXPECT_EQ(command.stamp.seq, 2);
  EXPECT_EQ(command.stamp.expires_utime, 5);
  EXPECT_EQ(command.command.action, task::Action::kStart);
  EXPECT_TRUE(command.command.carry);
  EXPECT_EQ(command.command.target, "red_book");
  const auto drive = parsed<ClientCommand>(
      R"({"type":"command","session":1,"seq":2,"expires":5,"kind":"drive","place":[0.5,-1,1.57]})");
  EXPECT_EQ(drive.command.place.y, -1.0);
  EXPECT_TRUE(parsed<ClientLease>(R"({"type":"lease","on":true,"take":true})").take);
  for (const char* place : {"[1,2]", "[1,2,1e99]", "[1,2,\"3\"]", "null"}) {
    EXPECT_NE(objection(R"({"type":"command","session":1,"seq":2,"expires":5,"kind":"drive","place":)" +
                        std::string(place) + "}"),
              "");
  }
  EXPECT_NE(objection(R"({"type":"command","session":1,"seq":2,"expires":5,"kind":"stop"})"), "");
}

TEST(ClientWord, MaySayMoreThanIsKnown) {
  EXPECT_EQ(parsed<ClientSeen>(R"({"type":"seen","number":7,"colour":"blue"})").picture, 7);
}

TEST(ClientWord, StopsWithoutAReason) {
  EXPECT_EQ(parsed<ClientStop>(R"({"type":"stop"})").reason, "");
}

TEST(ClientWord, IsRefusedWithWhatIsAllowed) {
  for (const char* wrong : {"",
                            "null",
                            "[]",
                            "7",
                            "{",
                            R"({"type":7})",
                            R"({"type":"fly"})",
                            R"({"type":"hello"})",
                            R"({"type":"hello","protocol":2})",
                            R"({"type":"pictures","on":1})",
                            R"({"type":"seen"})",
                            R"({"type":"seen","number":1.5})",
                            R"({"type":"seen","number":18446744073709551615})",
                            R"({"type":"look","channels":"A"})",
                            R"({"type":"look","channels":[1]})",
                            R"({"type":"play","speed":0})",
                            R"({"type":"play","speed":1e9})",
                            R"({"type":"play","speed":"fast"})",
                            R"({"type":"seek","utime":"12 "})",
                            R"({"type":"seek","utime":"99999999999999999999"})",
                            R"({"type":"step","by":2})",
                            R"({"type":"stop","reason":{}})"}) {
    EXPECT_NE(objection(wrong), "") << wrong;
  }
}

TEST(ClientWord, IsRefusedWhereItIsTooLong) {
  EXPECT_NE(objection(R"({"type":"stop","reason":")" + std::string(kLongestText + 1, 'x') + "\"}"), "");
  std::string channels = "\"A\"";
  for (std::size_t i = 0; i < kMostLooked; ++i) channels += ",\"A\"";
  EXPECT_NE(objection(R"({"type":"look","channels":[)" + channels + "]}"), "");
}

TEST(ClientWord, MayBeNestedAsDeeplyAsItsSizeAllows) {
  EXPECT_NE(objection(std::string(65536, '[')), "");
}

}  // namespace
}  // namespace markservo::mmi
