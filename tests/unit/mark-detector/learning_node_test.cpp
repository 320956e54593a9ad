// mark-detector learning for who asks on a bus.

#include "services/mark-detector/learning/learning_node.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <lcm/lcm-cpp.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <vector>

#include "tests/unit/command.hpp"
#include "tests/unit/log_events.hpp"
#include "tests/unit/mark-detector/learning_on_a_bus.hpp"

namespace markservo::mark_detector {
namespace {

using namespace test;

// What the command learns from the picture file, and writes into a robot file of its own.
std::string learned_by_command(const markservo::test::TemporaryFolder& folder, const std::string& picture) {
  const std::string own = folder.write("own.yaml", text_of(kProjectsRobot));
  const markservo::test::CommandResult result = markservo::test::run_command(
      MARKSERVO_BIN_DIR "/mark-detector --robot-file " + own + " --learn red_book --box 355,105,90,90 " + picture);
  const std::string words = "red_book, new: ";
  const std::size_t begin = result.output.find(words);
  if (begin == std::string::npos) return result.output;
  const std::size_t from = begin + words.size();
  return result.output.substr(from, result.output.find('\n', from) - from);
}

TEST_F(LearningOnABus, AnswersWithTheColourThatTheCommandLearnsOfTheSameRawPicture) {
  start_with_cameras("");
  const LearnResult result = ask(request_with(frame_));
  EXPECT_EQ(result.reason, "");
  const cv::Mat left(frame_.height, frame_.width, CV_8UC3, const_cast<std::uint8_t*>(frame_.left.data()));
  cv::imwrite(folder_.file("left.png"), left);
  EXPECT_EQ(interval_of(result), learned_by_command(folder_, folder_.file("left.png")));
}

TEST_F(LearningOnABus, AnswersWithTheColourThatTheCommandLearnsOfTheSameJpeg) {
  start_with_cameras("");
  const StereoFrame jpeg = as_jpeg(frame_);
  const LearnResult result = ask(request_with(jpeg));
  EXPECT_EQ(result.reason, "");
  const std::string file = folder_.write("left.jpg", std::string(jpeg.left.begin(), jpeg.left.end()));
  EXPECT_EQ(interval_of(result), learned_by_command(folder_, file));
}

TEST_F(LearningOnABus, TellsWhoAskedWhatItFindsInTheBox) {
  start_with_cameras("");
  const LearnResult result = ask(request_with(frame_));
  EXPECT_EQ(result.utime, kNow);
  EXPECT_EQ(result.request_session, 5);
  EXPECT_EQ(result.request_id, 1);
  EXPECT_EQ(result.mark, "red_book");
  EXPECT_TRUE(result.learned);
  EXPECT_FALSE(result.written);
  EXPECT_NEAR(result.covered, 78.0 * 78.0 / (90.0 * 90.0), 0.02);
  EXPECT_EQ(result.mask_width, 90);
  EXPECT_EQ(result.mask_size, 90 * 12);
}

TEST_F(LearningOnABus, WarnsOfTheMarksWhoseColoursOverlapAsTheCommandDoes) {
  start_with_cameras("");
  LearnRequest request = request_with(frame_);
  request.mark = "blue_book";
  const LearnResult result = ask(request);
  ASSERT_EQ(result.num_warnings, 2);
  EXPECT_EQ(result.warnings[0].overlaps, "red_book");
  EXPECT_EQ(result.warnings[0].text,
            "blue_book overlaps red_book, hue_deg: [345.0, 15.0], saturation: [0.5, 1.0], value: [0.2, 1.0]: what has "
            "both colours is taken for both");
  EXPECT_EQ(result.warnings[1].overlaps, "yellow_book");
}

TEST_F(LearningOnABus, WarnsOfABoxThatIsTooSmall) {
  start_with_cameras("");
  LearnRequest request = request_with(frame_);
  request.x = 390;
  request.y = 140;
  request.width = request.height = 20;
  const LearnResult result = ask(request);
  ASSERT_GE(result.num_warnings, 1);
  EXPECT_EQ(result.warnings[0].overlaps, "");
  EXPECT_EQ(result.warnings[0].text.rfind("it outgrows the box", 0), 0U) << result.warnings[0].text;
  EXPECT_EQ(result.covered, 1.0);
}

TEST_F(LearningOnABus, LearnsOnceAllPiecesHaveComeInWhateverOrder) {
  start_with_cameras("");
  std::vector<LearnRequest> pieces = pieces_of(request_with(frame_));
  ASSERT_EQ(pieces.size(), 16U);
  const LearnRequest lost = pieces[7];
  pieces.erase(pieces.begin() + 7);
  std::reverse(pieces.begin(), pieces.end());
  for (int sending = 0; sending < 2; ++sending) {
    for (const LearnRequest& piece : pieces) send_piece(piece);
  }
  EXPECT_TRUE(results_.empty());
  send_piece(lost);
  await(1);
  EXPECT_TRUE(results_.at(0).learned);
}

TEST_F(LearningOnABus, WritesNothingUnlessItMay) {
  start_with_cameras("");
  const std::string before = text_of(robot_file());
  const LearnResult result = ask(saving(request_with(frame_)));
  EXPECT_TRUE(result.learned);
  EXPECT_FALSE(result.written);
  EXPECT_NE(result.reason.find("--allow-saving"), std::string::npos) << result.reason;
  EXPECT_EQ(text_of(robot_file()), before);
}

TEST_F(LearningOnABus, WritesNothingThatIsNotAskedToBeSaved) {
  start_with_cameras("--allow-saving");
  const std::string before = text_of(robot_file());
  EXPECT_FALSE(ask(request_with(frame_)).written);
  EXPECT_EQ(text_of(robot_file()), before);
}

TEST_F(LearningOnABus, FindsTheMarkByTheColourThatItSaved) {
  start_with_cameras("--allow-saving");
  EXPECT_FALSE(red_book_is_seen());
  const LearnResult result = ask(saving(request_with(frame_)));
  EXPECT_TRUE(result.written);
  EXPECT_EQ(result.reason, "");
  EXPECT_EQ(text_of(robot_file()), with_colour(text_of(kProjectsRobot), "", "red_book",
                                               robot::load_robot_description(robot_file()).marks[1].colour))
      << "the rest of the file stays";
  EXPECT_EQ(to_text(robot::load_robot_description(robot_file()).marks[1].colour), interval_of(result));
  show(orange_frame(kNow + 100'000));
  EXPECT_TRUE(red_book_is_seen());
}

TEST_F(LearningOnABus, SaysThatServicesMustBeRestartedForAMarkThatIsNewToThem) {
  start_with_cameras("--allow-saving");
  std::string text = text_of(robot_file());
  const std::size_t at = text.find("  - name: red_book");
  text.insert(at,
              "  - name: orange_book\n    role: target\n    size: 0.025\n    surface: plane\n"
              "    colour: {hue_deg: [280.0, 300.0], saturation: [0.50, 1.0], value: [0.20, 1.0]}\n");
  folder_.write("robot.yaml", text);
  LearnRequest request = saving(request_with(frame_));
  request.mark = "orange_book";
  const LearnResult result = ask(request);
  EXPECT_TRUE(result.written);
  EXPECT_NE(result.reason.find("scripts/stack restart"), std::string::npos) << result.reason;
}

TEST_F(LearningOnABus, AnswersARepeatAgainAndWritesOnce) {
  start_with_cameras("--allow-saving");
  LearnRequest request = saving(request_with(frame_));
  send(request);
  send(request);  // while it is worked on
  await(1);
  const LearnResult first = results_.back();
  EXPECT_TRUE(first.written);
  const std::string untouched = folder_.write("robot.yaml", text_of(kProjectsRobot));
  request.utime += 1'000'000;
  LearnResult again = ask(request);
  EXPECT_EQ(results_.size(), 2U);
  EXPECT_EQ(again.seq, first.seq + 1);
  again.seq = first.seq;
  std::vector<std::uint8_t> one(static_cast<std::size_t>(first.getEncodedSize()));
  std::vector<std::uint8_t> other(static_cast<std::size_t>(again.getEncodedSize()));
  first.encode(one.data(), 0, first.getEncodedSize());
  again.encode(other.data(), 0, again.getEncodedSize());
  EXPECT_EQ(one, other);
  EXPECT_EQ(text_of(untouched), text_of(kProjectsRobot)) << "not written again";
}

// Two replays of one log give the same bytes, and none writes the robot's file.
TEST(LearningFromALog, IsTheSameTwiceAndWritesNothing) {
  const markservo::test::TemporaryFolder folder;
  const std::string robot_file = folder.write("robot.yaml", text_of(kProjectsRobot));
  {
    lcm::LCM log("file://" + folder.file("in.lcm") + "?mode=w");
    const StereoFrame frame = orange_frame(kNow);
    log.publish("STEREO_FRAME", &frame);
    for (int sending = 0; sending < 2; ++sending) {
      for (const LearnRequest& piece : pieces_of(saving(request_with(frame)))) log.publish("LEARN_REQUEST", &piece);
    }
  }
  const auto replay = [&](const std::string& name) {
    {
      bus::BusParameters parameters = bus::memq_parameters("mark-detector");
      parameters.urls = {"file://" + folder.file("in.lcm") + "?speed=0", "file://" + folder.file(name) + "?mode=w"};
      bus::Bus bus(parameters);
      CLI::App app;
      MarkDetectorNode node;
      node.add_options(app);
      app.parse("--allow-saving", false);
      node.configure(robot_file);
      node.start(bus);
      bus.spin();
    }
    return markservo::test::events_of(folder.file(name));
  };
  const auto first = replay("first.lcm");
  ASSERT_EQ(first.size(), 3U);
  EXPECT_EQ(first[1].first, "LEARN_RESULT");
  LearnResult result{};
  ASSERT_GT(result.decode(first[1].second.data(), 0, static_cast<int>(first[1].second.size())), 0);
  EXPECT_TRUE(result.learned);
  EXPECT_EQ(result.reason, "not saved: a log is replayed");
  EXPECT_EQ(first, replay("second.lcm"));
  EXPECT_EQ(text_of(robot_file), text_of(kProjectsRobot));
}

}  // namespace
}  // namespace markservo::mark_detector
