// The executable on pictures that no camera makes: an exit code that says what happened, and JSON when it is 0.

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <opencv2/imgcodecs.hpp>
#include <stdexcept>
#include <string>
#include <vector>

namespace markservo::mark_detector {
namespace {

struct Outcome {
  int exit_code = -1;  // of a program that ended by itself
  std::string output;  // of both streams
};

Outcome run_mark_detector(const std::string& arguments) {
  const std::string command = "'" MARKSERVO_BIN_DIR "/mark-detector' --robot-file '" MARKSERVO_SOURCE_DIR
                              "/config/robot.yaml' " +
                              arguments + " 2>&1";
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) throw std::runtime_error("cannot run " + command);
  Outcome run;
  char buffer[4096];
  while (std::fgets(buffer, sizeof buffer, pipe) != nullptr) run.output += buffer;
  const int status = pclose(pipe);
  if (WIFEXITED(status)) run.exit_code = WEXITSTATUS(status);
  return run;
}

class ExtremePicture : public ::testing::Test {
 protected:
  ExtremePicture()
      : folder_(std::filesystem::temp_directory_path() / ("markservo-extreme-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~ExtremePicture() override { std::filesystem::remove_all(folder_); }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  // All that the executable can do with the picture.
  Outcome look_at(const cv::Mat& picture) const {
    cv::imwrite(path("in.bmp"), picture);
    return run_mark_detector("--image '" + path("in.bmp") + "' --right '" + path("in.bmp") +
                             "' --all-blobs --annotate '" + path("out.png") + "' --mask-dir '" + path("masks") + "'");
  }

  std::filesystem::path folder_;
};

TEST_F(ExtremePicture, OfAnySizeIsReported) {
  for (const cv::Size size :
       {cv::Size(1, 1), cv::Size(4096, 1), cv::Size(1, 4096), cv::Size(63, 65), cv::Size(4096, 3072)}) {
    for (const cv::Scalar& colour : {cv::Scalar(0, 0, 0), cv::Scalar(255, 255, 255), cv::Scalar(40, 35, 190)}) {
      const Outcome run = look_at(cv::Mat(size, CV_8UC3, colour));
      ASSERT_EQ(run.exit_code, 0) << size << " " << colour << "\n" << run.output;
      const auto json = nlohmann::json::parse(run.output);
      EXPECT_EQ(json["width"], size.width);
      EXPECT_EQ(json["height"], size.height);
      EXPECT_EQ(json["marks"].size(), 4U);
    }
  }
}

TEST_F(ExtremePicture, FullOfSpecklesIsReported) {
  cv::Mat speckled(480, 640, CV_8UC3, cv::Scalar(120, 120, 120));
  cv::RNG random(5);
  for (int v = 0; v < speckled.rows; ++v) {
    for (int u = 0; u < speckled.cols; ++u) {
      if (random.uniform(0, 2) == 0) speckled.at<cv::Vec3b>(v, u) = {40, 35, 190};
    }
  }
  cv::Mat islands(480, 640, CV_8UC3, cv::Scalar(120, 120, 120));
  for (int v = 0; v + 10 < islands.rows; v += 12) {
    for (int u = 0; u + 10 < islands.cols; u += 12) islands(cv::Rect(u, v, 10, 10)).setTo(cv::Scalar(40, 35, 190));
  }
  for (const cv::Mat& picture : {speckled, islands}) {
    const Outcome run = look_at(picture);
    ASSERT_EQ(run.exit_code, 0) << run.output;
    EXPECT_LE(nlohmann::json::parse(run.output)["marks"][1]["left"]["blobs"].size(), 1024U);
  }
}

TEST_F(ExtremePicture, ThatIsNoneIsRefusedInOneLine) {
  cv::Mat whole(48, 64, CV_8UC3, cv::Scalar(40, 35, 190));
  std::vector<std::uint8_t> png;
  cv::imencode(".png", whole, png);
  const std::vector<std::vector<std::uint8_t>> files = {{},
                                                        {0},
                                                        {0xFF, 0xD8},
                                                        {0xFF, 0xD8, 0xFF, 0xC0},
                                                        {png.begin(), png.begin() + 20},
                                                        std::vector<std::uint8_t>(5000, 0x42)};
  for (const std::vector<std::uint8_t>& bytes : files) {
    std::ofstream(path("bad.png"), std::ios::binary)
        .write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
    const Outcome run = run_mark_detector("--image '" + path("bad.png") + "'");
    EXPECT_EQ(run.exit_code, 2) << run.output;
    EXPECT_NE(run.output.find("bad.png"), std::string::npos) << run.output;
  }
}

}  // namespace
}  // namespace markservo::mark_detector
