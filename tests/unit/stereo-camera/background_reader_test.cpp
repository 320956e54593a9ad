#include "services/stereo-camera/devices/background_reader.hpp"

#include <gtest/gtest.h>

#include <deque>
#include <stdexcept>
#include <utility>

namespace markservo::stereo_camera {
namespace {

using std::chrono::milliseconds;

// Plays results, then ends.
class ScriptedSource : public FrameSource {
 public:
  explicit ScriptedSource(std::deque<ReadStatus> script) : script_(std::move(script)) {}
  ReadResult read() override {
    if (script_.empty()) return {ReadStatus::kEnd, {}, ""};
    ReadResult result{script_.front(), {}, ""};
    script_.pop_front();
    result.pair.index = index_++;
    if (result.status == ReadStatus::kWaiting) result.reason = "camera is away";
    return result;
  }

 private:
  std::deque<ReadStatus> script_;
  std::int64_t index_ = 0;
};

class ThrowingSource : public FrameSource {
 public:
  ReadResult read() override { throw std::runtime_error("driver failed"); }
};

// All news of the source until it ends, added up; the pair is the last one.
BackgroundReader::News sum(std::deque<ReadStatus> script) {
  BackgroundReader reader(std::make_unique<ScriptedSource>(std::move(script)), {milliseconds(1)});
  BackgroundReader::News total;
  while (!total.ended) {
    BackgroundReader::News news = reader.take(milliseconds(1000));
    if (news.pair) {
      if (total.pair) ++total.skipped;
      total.pair = std::move(news.pair);
    }
    total.dropped += news.dropped;
    total.skipped += news.skipped;
    total.losses += news.losses;
    total.waiting = news.waiting;
    total.ended = news.ended;
  }
  return total;
}

TEST(BackgroundReader, LosesNoCountAndKeepsTheNewestPair) {
  const auto total = sum({ReadStatus::kPair, ReadStatus::kDropped, ReadStatus::kPair, ReadStatus::kPair});
  ASSERT_TRUE(total.pair);
  EXPECT_EQ(total.pair->index, 3);
  EXPECT_EQ(total.dropped, 1);
  EXPECT_EQ(total.skipped, 2);
  EXPECT_FALSE(total.waiting);
}

TEST(BackgroundReader, TriesAgainAndCountsEachLossOnce) {
  const auto total = sum({ReadStatus::kPair, ReadStatus::kWaiting, ReadStatus::kWaiting, ReadStatus::kPair,
                          ReadStatus::kWaiting, ReadStatus::kPair});
  EXPECT_EQ(total.losses, 2);
  EXPECT_FALSE(total.waiting);
  ASSERT_TRUE(total.pair);
  EXPECT_EQ(total.pair->index, 5);
}

TEST(BackgroundReader, TakesAnExceptionAsALostCamera) {
  BackgroundReader reader(std::make_unique<ThrowingSource>(), {milliseconds(1)});
  const auto news = reader.take(milliseconds(10'000));
  EXPECT_TRUE(news.waiting);
  EXPECT_EQ(news.reason, "driver failed");
}

TEST(BackgroundReader, EndsAtOnceWhileItWaitsForACamera) {
  BackgroundReader reader(std::make_unique<ThrowingSource>(), {std::chrono::hours(1)});
  EXPECT_TRUE(reader.take(milliseconds(10'000)).waiting);
}

}  // namespace
}  // namespace markservo::stereo_camera
