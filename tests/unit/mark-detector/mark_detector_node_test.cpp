#include "services/mark-detector/mark_detector_node.hpp"

#include <gtest/gtest.h>
#include <unistd.h>
#include <markservo/DetectedMark.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/StereoFrame.hpp>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <lcm/lcm-cpp.hpp>
#include <markservo/ServiceStatus.hpp>
#include <opencv2/imgcodecs.hpp>
#include <string>
#include <utility>
#include <vector>

#include "common/robot/configuration_error.hpp"
#include "services/mark-detector/picture/picture.hpp"
#include "tests/unit/bus/memq_bus.hpp"
#include "tests/unit/mark-detector/book_frame.hpp"
#include "tests/unit/mark-detector/synthetic_scene.hpp"

namespace markservo::mark_detector {
namespace {

using namespace test;

const std::string kRobotFile = std::string(MARKSERVO_SOURCE_DIR) + "/config/robot.yaml";

// A frame with the red book's mark at a disparity of 200 px.
StereoFrame frame_at(std::int64_t utime, double u) {
  return book_frame(utime, u, kRed, static_cast<unsigned>(utime));
}

void encode(StereoFrame& frame) {
  for (auto* side : {&frame.left, &frame.right}) {
    const cv::Mat image(frame.height, frame.width, CV_8UC3, side->data());
    std::vector<std::uint8_t> jpeg;
    cv::imencode(".jpg", image, jpeg);
    *side = jpeg;
  }
  frame.encoding = StereoFrame::ENCODING_JPEG;
  frame.left_size = static_cast<std::int32_t>(frame.left.size());
  frame.right_size = static_cast<std::int32_t>(frame.right.size());
}

// A configured node on a bus, with what it answers.
class NodeOnBus {
 public:
  explicit NodeOnBus(const bus::BusUrls& urls) : bus_(parameters(urls)) {
    CLI::App app;
    node_.add_options(app);
    app.parse(std::vector<std::string>{});
    node_.configure(kRobotFile);
    node_.start(bus_);
  }
  bus::Bus& bus() { return bus_; }

 private:
  static bus::BusParameters parameters(const bus::BusUrls& urls) {
    bus::BusParameters result;
    result.urls = urls;
    result.service_name = "mark-detector";
    result.heartbeat = false;
    return result;
  }
  bus::Bus bus_;
  MarkDetectorNode node_;
};

class LiveNode : public ::testing::Test {
 protected:
  LiveNode() : on_bus_({"memq://", "memq://"}), frames_(on_bus_.bus().advertise(channels::kStereoFrame)) {
    on_bus_.bus().on_each(channels::kMarkDetection, [this](const MarkDetection& m) { answers_.push_back(m); });
  }
  void send(StereoFrame frame) {
    frames_.publish(frame);
    settle(on_bus_.bus());
  }
  std::int64_t refused() { return bus::refused(on_bus_.bus(), "STEREO_FRAME"); }

  NodeOnBus on_bus_;
  bus::Publisher<StereoFrame> frames_;
  std::vector<MarkDetection> answers_;
};

TEST_F(LiveNode, AnswersEachFrameOnceWithItsIdentity) {
  send(frame_at(1000, 400.0));
  send(frame_at(2000, 402.0));
  ASSERT_EQ(answers_.size(), 2U);
  const MarkDetection& answer = answers_[1];
  EXPECT_EQ(answer.utime, 2000);
  EXPECT_EQ(answer.frame_utime, 2000);
  EXPECT_EQ(answer.frame_seq, 2);
  EXPECT_EQ(answer.seq, 2);
  EXPECT_EQ(answer.width, 640);
  EXPECT_EQ(answer.calibration.baseline, 0.065);
  ASSERT_EQ(answer.num_marks, 4);
  const DetectedMark& hand = answer.marks[0];
  EXPECT_EQ(hand.role, DetectedMark::ROLE_MANIPULATOR);
  EXPECT_EQ(hand.reason, "no pixel of its colour in either image");
  const DetectedMark& red = answer.marks[1];
  EXPECT_EQ(red.name, "red_book");
  EXPECT_EQ(red.reason, "");
  EXPECT_TRUE(red.left.seen && red.right.seen);
  EXPECT_NEAR(red.left.u, 402.0, 0.1);
  EXPECT_NEAR(red.right.u, 202.0, 0.1);
  EXPECT_EQ(red.left.patch.scale, 1);
  EXPECT_EQ(red.left.patch.bgr_size, red.left.patch.width * red.left.patch.height * 3);
}

TEST_F(LiveNode, ReadsJpeg) {
  StereoFrame frame = frame_at(1000, 400.0);
  encode(frame);
  send(frame);
  ASSERT_EQ(answers_.size(), 1U);
  EXPECT_NEAR(answers_[0].marks[1].left.u, 400.0, 0.6) << "colour has half the resolution";
}

TEST_F(LiveNode, DropsAndCountsABadJpeg) {
  StereoFrame broken = frame_at(1000, 400.0);
  encode(broken);
  broken.right = {0xFF, 0xD8, 0xFF, 0x00};
  broken.right_size = 4;
  send(broken);
  StereoFrame empty = frame_at(2000, 400.0);
  encode(empty);
  empty.left.clear();
  empty.left_size = 0;
  send(empty);
  StereoFrame other_size = frame_at(3000, 400.0);
  encode(other_size);
  other_size.width = 320;
  send(other_size);
  EXPECT_TRUE(answers_.empty());
  EXPECT_EQ(refused(), 3);
  send(frame_at(4000, 400.0));
  EXPECT_EQ(answers_.size(), 1U);
}

TEST_F(LiveNode, DropsAJpegThatClaimsAnotherSizeThanTheFrame) {
  StereoFrame frame = frame_at(1000, 400.0);
  encode(frame);
  // The frame header: FF C0, length, precision, height, width.
  const std::vector<std::uint8_t> marker = {0xFF, 0xC0};
  const auto header = std::search(frame.left.begin(), frame.left.end(), marker.begin(), marker.end());
  ASSERT_GT(frame.left.end() - header, 9);
  std::fill(header + 5, header + 9, std::uint8_t{0xFF});
  send(frame);
  EXPECT_TRUE(answers_.empty());
  EXPECT_EQ(refused(), 1);
}

TEST(ReplayedNode, WritesTheSameBytesTwice) {
  const auto folder = std::filesystem::temp_directory_path() / ("markservo-detector-" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  {
    lcm::LCM log("file://" + (folder / "in.lcm").string() + "?mode=w");
    for (std::int64_t i = 1; i <= 5; ++i) {
      StereoFrame frame = frame_at(i * 50000, 380.0 + 5.0 * static_cast<double>(i));
      log.publish("STEREO_FRAME", &frame);
    }
  }
  const auto replay = [&](const std::string& name) {
    {
      NodeOnBus node(
          {"file://" + (folder / "in.lcm").string() + "?speed=0", "file://" + (folder / name).string() + "?mode=w"});
      node.bus().spin();
    }
    std::vector<std::pair<std::string, std::string>> events;
    lcm::LogFile log((folder / name).string(), "r");
    while (const auto* event = log.good() ? log.readNextEvent() : nullptr) {
      events.emplace_back(event->channel,
                          std::string(static_cast<const char*>(event->data), static_cast<std::size_t>(event->datalen)));
    }
    return events;
  };
  const auto first = replay("first.lcm");
  EXPECT_EQ(first.size(), 5U);
  EXPECT_EQ(first, replay("second.lcm"));
  std::filesystem::remove_all(folder);
}

class PictureMode : public ::testing::Test {
 protected:
  PictureMode() : folder_(std::filesystem::temp_directory_path() / ("markservo-picture-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
    Picture picture(120, 90, kGrey);
    picture.draw({40.5, 40.5, 30.0, 0.0, kRed, 0.0});
    picture.draw({90.5, 60.5, 20.0, 0.0, kRed, 0.0});
    picture.expose();
    const ImageView view = picture.view();
    cv::imwrite(path("in.png"), cv::Mat(90, 120, CV_8UC3, const_cast<std::uint8_t*>(view.bgr)));
  }
  ~PictureMode() override { std::filesystem::remove_all(folder_); }
  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  // Standard output; arguments in the order of the command line.
  std::string run(std::vector<std::string> arguments, const std::string& robot_file = kRobotFile) const {
    CLI::App app;
    MarkDetectorNode node;
    node.add_options(app);
    std::reverse(arguments.begin(), arguments.end());
    app.parse(arguments);
    node.configure(robot_file);
    ::testing::internal::CaptureStdout();
    std::optional<int> exit_code;
    try {
      exit_code = node.run_alone("");
    } catch (...) {
      ::testing::internal::GetCapturedStdout();
      throw;
    }
    std::string text = ::testing::internal::GetCapturedStdout();
    EXPECT_EQ(exit_code, 0);
    return text;
  }

  std::filesystem::path folder_;
};

TEST_F(PictureMode, PrintsWhatItFindsAsJson) {
  const auto json = nlohmann::json::parse(run({"--image", path("in.png")}));
  EXPECT_EQ(json["width"], 120);
  ASSERT_EQ(json["marks"].size(), 4U);
  EXPECT_EQ(json["marks"][0]["reason"], "no pixel of its colour in the image");
  EXPECT_EQ(json["marks"][1]["reason"], "");
  EXPECT_NEAR(json["marks"][1]["left"]["u"].get<double>(), 40.5, 0.05);
  EXPECT_FALSE(json["marks"][1].contains("right"));
}

TEST_F(PictureMode, WritesMasksAndAnAnnotatedPicture) {
  const auto json =
      nlohmann::json::parse(run({"--image", path("in.png"), "--mark", "red=345:15:0.5:1:0.2:1", "--all-blobs",
                                 "--mask-dir", path("masks"), "--annotate", path("out.png")},
                                "no such file"));
  EXPECT_EQ(json["marks"][0]["left"]["blobs"].size(), 2U);
  EXPECT_EQ(cv::countNonZero(cv::imread(path("masks/red-left.png"), cv::IMREAD_GRAYSCALE)), 896)
      << "the clean-up takes the corners";
  EXPECT_EQ(cv::countNonZero(cv::imread(path("masks/red-left-blob-1.png"), cv::IMREAD_GRAYSCALE)), 396);
  EXPECT_EQ(cv::imread(path("out.png")).size(), cv::Size(120, 90));
}

TEST_F(PictureMode, RefusesPicturesItCannotUse) {
  EXPECT_THROW(run({"--image", path("none.png")}), ConfigurationError);
  EXPECT_THROW(run({"--image", kRobotFile}), ConfigurationError);
  cv::imwrite(path("small.png"), cv::Mat(9, 9, CV_8UC3, cv::Scalar::all(0)));
  EXPECT_THROW(run({"--image", path("in.png"), "--right", path("small.png")}), ConfigurationError);
  EXPECT_THROW(run({"--image", path("in.png"), "--annotate", path("no/such/folder/out.png")}), ConfigurationError);
  EXPECT_THROW(run({"--right", path("in.png")}), ConfigurationError);
  EXPECT_THROW(run({"--image", path("in.png"), "--mark", "red=1:2"}), ConfigurationError);
  EXPECT_THROW(run({"--image", path("in.png"), "--mark", "a=1:2:0:1:0:1", "--mark", "a=1:2:0:1:0:1"}),
               ConfigurationError);
}

}  // namespace
}  // namespace markservo::mark_detector
