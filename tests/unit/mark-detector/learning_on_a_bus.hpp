#pragma once

// mark-detector on a bus inside the test, asked for colours; it has a robot file of its own.

#include <gtest/gtest.h>

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <markservo/DetectedMark.hpp>
#include <markservo/LearnRequest.hpp>
#include <markservo/LearnResult.hpp>
#include <markservo/LearnWarning.hpp>
#include <markservo/MarkDetection.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "services/mark-detector/learning/robot_file_edit.hpp"
#include "services/mark-detector/mark_detector_node.hpp"
#include "tests/unit/bus/memq_bus.hpp"
#include "tests/unit/mark-detector/book_frame.hpp"
#include "tests/unit/mark-detector/request_pieces.hpp"
#include "tests/unit/temporary_folder.hpp"

namespace markservo::mark_detector::test {

inline constexpr char kProjectsRobot[] = MARKSERVO_SOURCE_DIR "/config/robot.yaml";
inline constexpr std::int64_t kNow = 1'000'000'000;  // us

inline std::string text_of(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

inline LearnRequest request_with(StereoFrame frame) {
  LearnRequest request{};
  request.utime = kNow;
  request.session = 5;
  request.request_id = 1;
  request.mark = "red_book";
  request.x = 355;
  request.y = 105;
  request.width = 90;
  request.height = 90;
  request.frame = std::move(frame);
  return request;
}

inline LearnRequest saving(LearnRequest request) {
  request.save = 1;
  return request;
}

inline std::string interval_of(const LearnResult& r) {
  return to_text({r.hue_min_deg, r.hue_max_deg, r.saturation_min, r.saturation_max, r.value_min, r.value_max});
}

class LearningOnABus : public ::testing::Test {
 protected:
  LearningOnABus() : bus_(bus::memq_parameters("mark-detector")) {
    std::filesystem::copy_file(kProjectsRobot, robot_file());
  }

  void start(const std::string& options) {
    node_.add_options(app_);
    app_.parse(options, false);
    node_.configure(robot_file());
    node_.start(bus_);
    bus_.on_each(channels::kLearnResult, [this](const LearnResult& result) { results_.push_back(result); });
    bus_.on_each(channels::kMarkDetection, [this](const MarkDetection& detection) { detection_ = detection; });
  }
  void start_with_cameras(const std::string& options) {
    start(options);
    show(frame_);
  }

  std::string robot_file() const { return folder_.file("robot.yaml"); }

  void show(StereoFrame frame) {
    frames_.publish(frame);
    bus::settle(bus_);
  }
  bool red_book_is_seen() const { return detection_.marks.at(1).left.seen && detection_.marks.at(1).right.seen; }

  void send_piece(LearnRequest piece) {
    requests_.publish(piece);
    bus::settle(bus_);
  }
  // In pieces, as whole as it is.
  void send(const LearnRequest& request) {
    for (const LearnRequest& piece : pieces_of(request)) send_piece(piece);
  }
  // Waits until there are so many answers, far longer than they take.
  void await(std::size_t answers) {
    const auto end = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (results_.size() < answers && std::chrono::steady_clock::now() < end) {
      bus_.poll(std::chrono::milliseconds(5));
    }
    ASSERT_GE(results_.size(), answers);
  }
  LearnResult ask(const LearnRequest& request) {
    const std::size_t before = results_.size();
    send(request);
    await(before + 1);
    return results_.size() > before ? results_.back() : LearnResult{};
  }

  const markservo::test::TemporaryFolder folder_;
  const StereoFrame frame_ = orange_frame(kNow);
  CLI::App app_;
  bus::Bus bus_;
  MarkDetectorNode node_;
  bus::Publisher<StereoFrame> frames_ = bus_.advertise(channels::kStereoFrame);
  bus::Publisher<LearnRequest> requests_ = bus_.advertise(channels::kLearnRequest);
  std::vector<LearnResult> results_;
  MarkDetection detection_{};
};

}  // namespace markservo::mark_detector::test
