#pragma once

// The messages of one frame's way through the chain, as bytes of the bus.

#include <cstddef>
#include <cstdint>
#include <markservo/JointCommand.hpp>
#include <markservo/MarkDetection.hpp>
#include <markservo/ServoStatus.hpp>
#include <markservo/StereoFrame.hpp>
#include <markservo/StereoMatches.hpp>
#include <markservo/TargetPose.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/unit/encoded.hpp"

namespace markservo::mmi {

struct FrameMessages {
  static constexpr int kWidth = 32;                                         // px
  static constexpr int kHeight = 16;                                        // px
  static constexpr std::size_t kBytes = std::size_t{kWidth} * kHeight * 3;  // of each picture

  std::int64_t session = 41;
  std::int64_t seq = 1;
  std::int64_t utime = 1'600'000'000'000'000;  // us

  std::vector<std::uint8_t> frame() const {
    StereoFrame frame{};
    frame.utime = utime;
    frame.session = session;
    frame.seq = seq;
    frame.calibration.fx = 784.0;
    frame.calibration.fy = 784.0;
    frame.calibration.baseline = 0.065;
    frame.width = kWidth;
    frame.height = kHeight;
    frame.left.assign(kBytes, 200);
    frame.right.assign(kBytes, 50);
    frame.left_size = static_cast<std::int32_t>(frame.left.size());
    frame.right_size = static_cast<std::int32_t>(frame.right.size());
    return test::encoded(frame);
  }

  // MARK_DETECTION, STEREO_MATCHES, TARGET_POSE, SERVO_STATUS, in this order.
  std::vector<std::pair<std::string, std::vector<std::uint8_t>>> answers() const {
    return {{"MARK_DETECTION", test::encoded(named(MarkDetection{}))},
            {"STEREO_MATCHES", test::encoded(named(StereoMatches{}))},
            {"TARGET_POSE", test::encoded(named(TargetPose{}))},
            {"SERVO_STATUS", test::encoded(named(ServoStatus{}))}};
  }

 private:
  template <class M>
  M named(M message) const {
    message.utime = utime;
    message.session = 7;
    message.seq = seq;
    message.frame_session = session;
    message.frame_seq = seq;
    message.frame_utime = utime;
    return message;
  }
};

}  // namespace markservo::mmi
