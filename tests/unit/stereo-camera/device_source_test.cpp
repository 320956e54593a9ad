#include "services/stereo-camera/devices/device_source.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <utility>

#include "services/stereo-camera/devices/v4l2_device.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::stereo_camera {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

constexpr double kRate_hz = 10.0;  // a frame is 100,000 us

// What both cameras did, in order.
using Journal = std::vector<std::string>;

// A camera that delivers frames of given times, then is lost. A negative time is a damaged frame.
class FakeCamera : public CaptureDevice {
 public:
  FakeCamera(std::string name, std::deque<std::int64_t> times, Journal& journal, int width)
      : name_(std::move(name)), times_(std::move(times)), journal_(journal), width_(width) {}
  bool grab() override {
    journal_.push_back("grab " + name_);
    if (times_.empty()) return false;
    now_ = times_.front();
    times_.pop_front();
    return true;
  }
  std::int64_t utime() override { return std::abs(now_); }
  cv::Mat retrieve() override {
    journal_.push_back("retrieve " + name_);
    return now_ < 0 ? cv::Mat() : cv::Mat(2, width_, CV_8UC3, cv::Scalar::all(0));
  }
  double rate() const override { return 0.0; }

 private:
  std::string name_;
  std::deque<std::int64_t> times_;
  Journal& journal_;
  int width_;
  std::int64_t now_ = 0;
};

// Each opening takes the next list of times; when none is left the camera is not there.
DeviceOpener camera(const std::string& name, std::deque<std::deque<std::int64_t>> openings, Journal& journal,
                    int width = 4) {
  auto left = std::make_shared<std::deque<std::deque<std::int64_t>>>(std::move(openings));
  return [=, &journal](std::string& reason) -> std::unique_ptr<CaptureDevice> {
    if (left->empty()) {
      reason = name + " is not there";
      return nullptr;
    }
    auto device = std::make_unique<FakeCamera>(name, left->front(), journal, width);
    left->pop_front();
    return device;
  };
}

TEST(TwoCameras, AreBothGrabbedBeforeEitherIsDecoded) {
  Journal journal;
  DeviceSource source(camera("L", {{1'000'000}}, journal), camera("R", {{1'000'000}}, journal), kRate_hz);
  EXPECT_EQ(source.read().status, ReadStatus::kPair);
  EXPECT_THAT(journal, ElementsAre("grab L", "grab R", "retrieve L", "retrieve R"));
}

TEST(TwoCameras, GiveThePairTheMiddleOfBothTimes) {
  Journal journal;
  DeviceSource source(camera("L", {{1'000'000}}, journal), camera("R", {{1'040'000}}, journal), kRate_hz);
  EXPECT_EQ(source.read().pair.exposure_utime, 1'020'000);
}

TEST(TwoCameras, DropTheOlderFrameAndPairTheNextWithTheOneHeld) {
  Journal journal;
  DeviceSource source(camera("L", {{1'000'000, 1'100'000}}, journal), camera("R", {{1'090'000}}, journal), kRate_hz);
  EXPECT_EQ(source.read().status, ReadStatus::kDropped);
  const ReadResult second = source.read();
  ASSERT_EQ(second.status, ReadStatus::kPair);
  EXPECT_EQ(second.pair.exposure_utime, 1'095'000);
  EXPECT_THAT(journal, ElementsAre("grab L", "grab R", "grab L", "retrieve L", "retrieve R"));
}

TEST(TwoCameras, FindEachOthersFramesAfterARun) {
  Journal journal;
  DeviceSource source(camera("L", {{1'500'000, 1'600'000, 1'700'000}}, journal),
                      camera("R", {{1'210'000, 1'310'000, 1'410'000, 1'510'000, 1'610'000, 1'710'000}}, journal),
                      kRate_hz);
  std::vector<ReadStatus> statuses;
  for (int i = 0; i < 6; ++i) statuses.push_back(source.read().status);
  EXPECT_THAT(statuses, ElementsAre(ReadStatus::kDropped, ReadStatus::kDropped, ReadStatus::kDropped, ReadStatus::kPair,
                                    ReadStatus::kPair, ReadStatus::kPair));
}

TEST(TwoCameras, DropADamagedFrameAndGoOn) {
  Journal journal;
  DeviceSource source(camera("L", {{1'000'000, -1'100'000, 1'200'000}}, journal),
                      camera("R", {{1'000'000, 1'100'000, 1'200'000}}, journal), kRate_hz);
  EXPECT_EQ(source.read().status, ReadStatus::kPair);
  const ReadResult damaged = source.read();
  EXPECT_EQ(damaged.status, ReadStatus::kDropped);
  EXPECT_THAT(damaged.reason, HasSubstr("left frame is damaged"));
  EXPECT_EQ(source.read().status, ReadStatus::kPair);
}

TEST(TwoCameras, WaitForALostOneAndOpenBothAgain) {
  Journal journal;
  DeviceSource source(camera("L", {{1'000'000, 1'100'000}, {5'000'000}}, journal),
                      camera("R", {{1'000'000}, {5'000'000}}, journal), kRate_hz);
  EXPECT_EQ(source.read().status, ReadStatus::kPair);
  const ReadResult lost = source.read();
  EXPECT_EQ(lost.status, ReadStatus::kWaiting);
  EXPECT_THAT(lost.reason, HasSubstr("right camera"));
  const ReadResult back = source.read();
  ASSERT_EQ(back.status, ReadStatus::kPair);
  EXPECT_EQ(back.pair.exposure_utime, 5'000'000);
}

TEST(TwoCameras, WaitWhileOneIsNotThere) {
  Journal journal;
  DeviceSource source(camera("L", {{1'000'000}, {2'000'000}}, journal), camera("R", {}, journal), kRate_hz);
  for (int i = 0; i < 3; ++i) {
    const ReadResult result = source.read();
    EXPECT_EQ(result.status, ReadStatus::kWaiting);
    EXPECT_THAT(result.reason, HasSubstr("is not there"));
  }
}

TEST(SideBySideCamera, GivesBothHalvesWithOneTime) {
  Journal journal;
  DeviceSource source(camera("both", {{1'000'000}}, journal, 8), kRate_hz);
  const ReadResult result = source.read();
  ASSERT_EQ(result.status, ReadStatus::kPair);
  EXPECT_EQ(result.pair.left.cols, 4);
  EXPECT_EQ(result.pair.right.cols, 4);
  EXPECT_EQ(result.pair.exposure_utime, 1'000'000);
  EXPECT_EQ(source.read().status, ReadStatus::kWaiting);
}

TEST(SideBySideCamera, OfOddWidthIsDropped) {
  Journal journal;
  DeviceSource source(camera("both", {{1'000'000}}, journal, 7), kRate_hz);
  EXPECT_EQ(source.read().status, ReadStatus::kDropped);
}

TEST(V4l2Camera, ThatIsNotThereIsNamed) {
  const test::TemporaryFolder folder;
  V4l2Settings settings;
  settings.size = cv::Size(640, 480);
  std::string reason;
  settings.path = folder.file("video7");
  EXPECT_EQ(open_v4l2(settings, reason), nullptr);
  EXPECT_THAT(reason, HasSubstr("video7: there is no such device"));
  settings.path = folder.write("picture", "");
  EXPECT_EQ(open_v4l2(settings, reason), nullptr);
  EXPECT_THAT(reason, HasSubstr("is no camera device"));
  settings.path = "/dev/null";
  EXPECT_EQ(open_v4l2(settings, reason), nullptr);
  EXPECT_THAT(reason, HasSubstr("gives no video"));
}

}  // namespace
}  // namespace markservo::stereo_camera
