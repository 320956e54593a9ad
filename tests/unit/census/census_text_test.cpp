#include "common/census/census_text.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace markservo::census {
namespace {

TEST(SessionOf, TakesWhatJsonShows) {
  for (const std::int64_t session : {std::int64_t{1}, std::int64_t{-5}, std::int64_t{8'968'550'092'823'937'062},
                                     std::numeric_limits<std::int64_t>::min()}) {
    ServiceWord word;
    word.session = session;
    EXPECT_EQ(session_of(json_of(word).at("session").get<std::string>()), session);
  }
}

TEST(SessionOf, TakesNothingElse) {
  for (const char* text : {"", "0x", "5", "0x12345678901234567", "0x1g", "-0x1", "0x-1", " 0x1"}) {
    EXPECT_FALSE(session_of(text)) << text;
  }
}

}  // namespace
}  // namespace markservo::census
