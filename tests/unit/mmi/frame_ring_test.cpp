#include "services/mmi/pictures/frame_ring.hpp"

#include <gtest/gtest.h>

#include "common/reflection/type_catalog.hpp"
#include "tests/unit/mmi/frame_messages.hpp"

namespace markservo::mmi {
namespace {

class HeardFrames : public ::testing::Test {
 protected:
  void hear_frame(std::int64_t seq, double now) {
    messages_.seq = seq;
    const Bytes bytes = std::make_shared<const std::vector<std::uint8_t>>(messages_.frame());
    const auto message = reflection::decode(reflection::TypeCatalog::ours(), bytes->data(), bytes->size());
    ring_.add(message.fields, bytes, at(now), now);
  }

  void hear_answers(std::int64_t seq, double now, std::size_t how_many = 4) {
    messages_.seq = seq;
    for (const auto& [channel, content] : messages_.answers()) {
      if (how_many-- == 0) return;
      const Bytes bytes = std::make_shared<const std::vector<std::uint8_t>>(content);
      const auto message = reflection::decode(reflection::TypeCatalog::ours(), bytes->data(), bytes->size());
      ring_.join(channel, message.fields, bytes, at(now));
    }
  }

  std::int64_t ready(double now) const {
    const auto frame = ring_.ready(now);
    return frame ? frame->seq : 0;
  }

  static std::int64_t at(double now) { return static_cast<std::int64_t>(1e6 * now); }

  FrameMessages messages_;
  FrameRing ring_;
};

TEST_F(HeardFrames, AreShownOnceAllAnswersAreThere) {
  hear_frame(1, 0.0);
  EXPECT_EQ(ready(0.01), 0);
  hear_answers(1, 0.01, 3);
  EXPECT_EQ(ready(0.02), 0);
  hear_answers(1, 0.02);
  EXPECT_EQ(ready(0.02), 1);
}

TEST_F(HeardFrames, AreShownWithoutAnswersThatDoNotCome) {
  hear_frame(1, 0.0);
  EXPECT_EQ(ready(0.099), 0);
  EXPECT_EQ(ready(0.101), 1);
}

TEST_F(HeardFrames, StandBackUntilANewerOneIsComplete) {
  hear_frame(1, 0.0);
  hear_answers(1, 0.01);
  hear_frame(2, 0.033);
  EXPECT_EQ(ready(0.04), 1);
  hear_answers(2, 0.045);
  EXPECT_EQ(ready(0.05), 2);
}

TEST_F(HeardFrames, TakeNoAnswerToAnotherFrame) {
  hear_frame(1, 0.0);
  hear_frame(2, 0.033);
  hear_answers(2, 0.04);
  EXPECT_FALSE(ring_.ready(0.05)->part(FramePart::kDetection) == nullptr);
  messages_.session = 99;
  hear_answers(1, 0.04);
  EXPECT_EQ(ready(0.05), 2);
  ring_ = FrameRing();
  hear_answers(1, 0.06);
  EXPECT_EQ(ready(0.2), 0);
}

TEST_F(HeardFrames, TellHowLongTheirAnswersTook) {
  for (int seq = 1; seq <= 3; ++seq) {
    hear_frame(seq, seq);
    hear_answers(seq, seq + 0.01 * seq);
  }
  EXPECT_NEAR(ring_.delays().at("TARGET_POSE"), 0.02, 1e-6);
  EXPECT_EQ(ring_.delays().count("STEREO_FRAME"), 0U);
}

TEST_F(HeardFrames, AreForgottenBeforeTheyFillTheMemory) {
  for (int seq = 1; seq <= 1000; ++seq) hear_frame(seq, 0.01 * seq);
  hear_answers(1, 10.0);
  EXPECT_EQ(ring_.delays().count("TARGET_POSE"), 0U);
  EXPECT_EQ(ring_.newest()->seq, 1000);
}

TEST_F(HeardFrames, WaitLongerWhereAnswersTakeLonger) {
  for (int seq = 1; seq <= 10; ++seq) {
    hear_frame(seq, 0.1 * seq);
    if (seq > 2) hear_answers(seq - 2, 0.1 * seq);
  }
  EXPECT_EQ(ready(1.0), 8) << "the newest with its answers, 0.2 s after it came";
}

}  // namespace
}  // namespace markservo::mmi
