// The rules of LEARN_REQUEST and LEARN_RESULT.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <markservo/LearnRequest.hpp>
#include <markservo/LearnResult.hpp>
#include <markservo/LearnWarning.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/unit/messages/violation.hpp"

namespace markservo::messages {
namespace {

LearnRequest request() {
  LearnRequest request{};
  request.session = 1;
  request.request_id = 1;
  request.mark = "red_book";
  return request;
}

LearnResult result() {
  LearnResult result{};
  result.mark = "red_book";
  result.learned = 1;
  result.hue_min_deg = 345.0;
  result.hue_max_deg = 15.0;
  result.saturation_max = 1.0;
  result.value_max = 1.0;
  result.covered = 0.9;
  result.mask_width = 9;
  result.mask_height = 2;
  result.mask_size = 4;
  result.mask.resize(4);
  return result;
}

TEST(LearnRequestRules, AskWhoAsksAndForWhat) {
  EXPECT_EQ(violation(request()), "");
  LearnRequest nobody = request();
  nobody.session = 0;
  EXPECT_EQ(violation(nobody), "session is 0; allowed: 1 or more");
  LearnRequest nameless = request();
  nameless.request_id = 0;
  EXPECT_EQ(violation(nameless), "request_id is 0; allowed: 1 or more");
}

// So that who asks is told.
TEST(LearnRequestRules, LeaveBoxAndFrameToTheAnswer) {
  LearnRequest odd = request();
  odd.x = -5;
  odd.frame.encoding = 9;
  odd.frame.calibration.fx = std::nan("");
  EXPECT_EQ(violation(odd), "");
}

TEST(LearnResultRules, AcceptAColourWithItsMaskAndAnAnswerWithoutOne) {
  EXPECT_EQ(violation(result()), "");
  EXPECT_EQ(violation(LearnResult{}), "");
}

TEST(LearnResultRules, RefuseWhatIsNoColourShareOrMask) {
  const std::vector<std::pair<std::function<void(LearnResult&)>, std::string>> cases{
      {[](auto& m) { m.hue_min_deg = std::nan(""); }, "a hue is nan; allowed: 0 to 360 degrees"},
      {[](auto& m) { m.hue_max_deg = 361.0; }, "a hue is 361; allowed: 0 to 360 degrees"},
      {[](auto& m) { m.saturation_min = -0.1; }, "a saturation or value is -0.1; allowed: 0 to 1"},
      {[](auto& m) { m.value_max = INFINITY; }, "a saturation or value is inf; allowed: 0 to 1"},
      {[](auto& m) { m.covered = 1.1; }, "covered is 1.1; allowed: 0 to 1"},
      {[](auto& m) { m.mask_width = 8; }, "mask_size is 4; allowed: mask_height * ((mask_width + 7) / 8) bytes"},
      {[](auto& m) { m.mask_height = -2; }, "the mask's width or height is -2; allowed: 0 to 16384 px"},
      {[](auto& m) { m.mask_width = 100000; }, "the mask's width or height is 100000; allowed: 0 to 16384 px"},
      {[](auto& m) { m.request_id = -1; }, "request_id is -1; allowed: 0 or more"},
  };
  for (const auto& [change, why] : cases) {
    LearnResult changed = result();
    change(changed);
    EXPECT_EQ(violation(changed), why);
  }
}

}  // namespace
}  // namespace markservo::messages
