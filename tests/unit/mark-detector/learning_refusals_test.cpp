// What mark-detector does not learn on a bus, and what it says of it.

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/unit/mark-detector/learning_on_a_bus.hpp"

namespace markservo::mark_detector {
namespace {

using namespace test;

TEST_F(LearningOnABus, DoesNotWorkAgainOnARequestWhoseAnswerItHasForgotten) {
  start_with_cameras("--allow-saving");
  ask(saving(request_with(frame_)));
  LearnRequest other = request_with(frame_);
  other.x = -1;
  for (other.request_id = 2; other.request_id <= 9; ++other.request_id) ask(other);
  folder_.write("robot.yaml", text_of(kProjectsRobot));
  const LearnResult again = ask(saving(request_with(frame_)));
  EXPECT_FALSE(again.learned);
  EXPECT_NE(again.reason.find("answered long ago"), std::string::npos) << again.reason;
  EXPECT_EQ(text_of(robot_file()), text_of(kProjectsRobot));
}

TEST_F(LearningOnABus, RefusesInWordsWhatItCannotLearnFrom) {
  start_with_cameras("--allow-saving");
  const std::string before = text_of(robot_file());
  const StereoFrame jpeg = as_jpeg(frame_);
  const std::vector<std::pair<std::function<void(LearnRequest&)>, std::string>> cases{
      {[](auto& m) { m.width = 0; }, "the box is 355,105,0,90; allowed: "},
      {[](auto& m) { m.height = -90; }, "the box is "},
      {[](auto& m) { m.x = -1; }, "the box is -1,105,90,90"},
      {[](auto& m) { m.x = 551; }, "inside the frame's 640 x 480 px"},
      {[](auto& m) { m.y = 2147483647; }, "the box is 355,2147483647,90,90"},
      {[](auto& m) { m.width = 2147483647; }, "the box is "},
      {[](auto& m) { m.x = m.y = 10; }, "of it has a hue"},
      {[](auto& m) { m.mark = "green_book"; }, "mark is 'green_book'; allowed: a mark of "},
      {[](auto& m) { m.mark = ""; }, "mark is ''; allowed: "},
      {[](auto& m) { m.frame.encoding = 7; }, "the frame's encoding is 7; allowed: 0 (BGR8) or 1 (JPEG)"},
      {[](auto& m) { m.frame.width = 641; }, "the frame's left_size is 921600; allowed: "},
      {[](auto& m) { m.frame.calibration.cy = std::nan(""); }, "the frame's calibration is not finite"},
      {[](auto& m) { m.frame.width = 480, m.frame.height = 640; },
       "the frame is 480 x 640 px; allowed: STEREO_FRAME's 640 x 480"},
      {[&](auto& m) { m.frame = jpeg, m.frame.left.resize(20); }, "left is no JPEG that can be read"},
      {[&](auto& m) {
         m.frame = jpeg, m.frame.left = {'G', 'I', 'F'};
       },
       "left is no JPEG that can be read"},
      {[&](auto& m) { m.frame = jpeg, m.frame.left.clear(); },
       "left_size is 0; allowed: 1 to width * height * 3 bytes"},
  };
  LearnRequest request = saving(request_with(frame_));
  for (const auto& [change, why] : cases) {
    LearnRequest changed = request;
    change(changed);
    const LearnResult result = ask(changed);
    EXPECT_FALSE(result.learned || result.written) << why;
    EXPECT_NE(result.reason.find(why), std::string::npos) << "'" << result.reason << "' lacks '" << why << "'";
    EXPECT_EQ(result.request_id, request.request_id);
    ++request.request_id;
  }
  EXPECT_EQ(text_of(robot_file()), before);
}

TEST_F(LearningOnABus, RefusesAPieceThatDoesNotFit) {
  start_with_cameras("--allow-saving");
  const LearnRequest whole = pieces_of(request_with(as_jpeg(frame_))).front();
  const std::vector<std::pair<std::function<void(LearnRequest&)>, std::string>> cases{
      {[](auto& m) { m.offset = -1; }, "from -1 on; allowed: 1 or more, within the picture's "},
      {[](auto& m) { m.offset = 2147483647; }, "from 2147483647 on; allowed: "},
      {[](auto& m) { m.piece.clear(), m.piece_size = 0; }, "the piece is 0 bytes"},
      {[](auto& m) { m.left_size = m.piece_size - 1; }, "allowed: 1 or more, within the picture's "},
      {[](auto& m) { m.left_size = 2147483647; }, "left_size is 2147483647; allowed: "},
      {[](auto& m) { m.left_size = -4; }, "left_size is -4; allowed: "},
  };
  LearnRequest piece = whole;
  for (const auto& [change, why] : cases) {
    LearnRequest changed = piece;
    change(changed);
    const std::size_t before = results_.size();
    send_piece(changed);
    ASSERT_EQ(results_.size(), before + 1) << why;
    EXPECT_NE(results_.back().reason.find(why), std::string::npos)
        << "'" << results_.back().reason << "' lacks " << why;
    ++piece.request_id;
  }
}

TEST_F(LearningOnABus, KeepsNoMoreThanTwoIncompletePictures) {
  start_with_cameras("");
  std::vector<std::vector<LearnRequest>> all;
  LearnRequest request = request_with(frame_);
  for (request.request_id = 1; request.request_id <= 3; ++request.request_id) {
    all.push_back(pieces_of(request));
    for (std::size_t i = 1; i < all.back().size(); ++i) send_piece(all.back()[i]);
  }
  send_piece(all[0][0]);
  send_piece(all[2][0]);
  await(1);
  EXPECT_EQ(results_.at(0).request_id, 3) << "of the first one the pieces were given up";
}

TEST_F(LearningOnABus, SaysWhyTheFileCannotBeWritten) {
  start_with_cameras("--allow-saving");
  std::string text = text_of(robot_file());
  text.replace(text.find("hue_deg: [345.0, 15.0]"), 22, "hue_deg: [!!float 345.0, 15.0]");
  folder_.write("robot.yaml", text);
  const LearnResult result = ask(saving(request_with(frame_)));
  EXPECT_TRUE(result.learned);
  EXPECT_FALSE(result.written);
  EXPECT_NE(result.reason.find("cannot be edited; allowed: plain numbers"), std::string::npos) << result.reason;
  EXPECT_EQ(text_of(robot_file()), text);
}

TEST_F(LearningOnABus, RefusesASecondWriterUntilTheFirstIsSilent) {
  start_with_cameras("--allow-saving");
  EXPECT_TRUE(ask(request_with(frame_)).learned);
  const std::string before = text_of(robot_file());
  LearnRequest second = saving(request_with(frame_));
  second.session = 6;
  EXPECT_EQ(ask(second).reason, "two write LEARN_REQUEST: sessions 5 and 6; allowed: the other after 5 s");
  EXPECT_EQ(text_of(robot_file()), before);
  LearnRequest first = request_with(frame_);
  first.request_id = 2;
  EXPECT_TRUE(ask(first).learned) << "who asked first goes on";
  show(orange_frame(kNow + 5'000'000));
  second.utime += 5'000'000;
  second.request_id = 2;
  EXPECT_TRUE(ask(second).learned);
}

TEST_F(LearningOnABus, RefusesARecordingsRequestAndTakesItStampedAnew) {
  start_with_cameras("--allow-saving");
  const std::string before = text_of(robot_file());
  LearnRequest request = saving(request_with(frame_));
  for (const std::int64_t off : {-2'100'000, 60'000'000}) {
    request.utime = kNow + off;
    const LearnResult result = ask(request);
    EXPECT_FALSE(result.learned);
    EXPECT_NE(result.reason.find("than STEREO_FRAME; allowed: 2.00 s"), std::string::npos) << result.reason;
  }
  EXPECT_EQ(text_of(robot_file()), before);
  request.utime = kNow;
  EXPECT_TRUE(ask(request).written);
}

TEST_F(LearningOnABus, RefusesWhileNoFrameWasHeard) {
  start("");
  EXPECT_EQ(ask(request_with(frame_)).reason, "no STEREO_FRAME was heard yet; allowed: while cameras send");
  show(frame_);
  EXPECT_TRUE(ask(request_with(frame_)).learned);
}

TEST_F(LearningOnABus, LetsNoMoreThanTwoWait) {
  start_with_cameras("");
  LearnRequest request = request_with(as_jpeg(frame_));  // of one piece
  for (request.request_id = 1; request.request_id <= 3; ++request.request_id) {
    for (LearnRequest& piece : pieces_of(request)) requests_.publish(piece);
  }
  bus_.poll(std::chrono::milliseconds(0));
  await(3);
  EXPECT_EQ(results_[0].request_id, 3);
  EXPECT_EQ(results_[0].reason, "others wait already; allowed: once they are answered");
  EXPECT_EQ(results_[1].request_id, 1);
  EXPECT_EQ(results_[2].request_id, 2);
  EXPECT_TRUE(results_[1].learned && results_[2].learned);
  request.request_id = 3;
  EXPECT_TRUE(ask(request).learned);
}

TEST_F(LearningOnABus, RefusesWhereTheDetectorLooksForOtherMarks) {
  start_with_cameras("--mark red_book=345:15:0.5:1:0.2:1");
  EXPECT_EQ(ask(request_with(frame_)).reason, "mark-detector has marks of its own; allowed: without --mark");
}

}  // namespace
}  // namespace markservo::mark_detector
