#pragma once

// Frames with the mark of a book, also in a colour that no mark of the project's robot has.

#include <cstdint>
#include <markservo/StereoFrame.hpp>
#include <opencv2/imgcodecs.hpp>
#include <vector>

#include "tests/unit/mark-detector/synthetic_scene.hpp"

namespace markservo::mark_detector::test {

inline constexpr Colour kOrange{40.0, 110.0, 200.0};  // hue 26: neither the red book's nor the yellow one's

// 640 x 480 px, raw, with a book's mark of 78 px around `column`, 150 on the left, at a disparity of 200 px.
inline StereoFrame book_frame(std::int64_t utime, double column, const Colour& colour, unsigned noise) {
  const auto expose = [&](double at, unsigned seed) {
    Picture picture(640, 480, kGrey);
    picture.draw({at, 150.0, 78.0, 0.0, colour, 0.1});
    picture.expose(1.0, 3.0, seed);
    const ImageView view = picture.view();
    return std::vector<std::uint8_t>(view.bgr, view.row(view.height));
  };
  StereoFrame frame{};
  frame.utime = utime;
  frame.session = 77;
  frame.seq = utime;
  frame.calibration = {784.0, 784.0, 319.5, 319.5, 239.5, 0.065};
  frame.width = 640;
  frame.height = 480;
  frame.encoding = StereoFrame::ENCODING_BGR8;
  frame.left = expose(column, noise);
  frame.right = expose(column - 200.0, noise + 1000);
  frame.left_size = static_cast<std::int32_t>(frame.left.size());
  frame.right_size = static_cast<std::int32_t>(frame.right.size());
  return frame;
}

inline StereoFrame orange_frame(std::int64_t utime, const Colour& colour = kOrange) {
  return book_frame(utime, 400.0, colour, 1);
}

inline StereoFrame as_jpeg(StereoFrame frame) {
  for (auto* side : {&frame.left, &frame.right}) {
    const cv::Mat image(frame.height, frame.width, CV_8UC3, side->data());
    std::vector<std::uint8_t> jpeg;
    cv::imencode(".jpg", image, jpeg);
    *side = jpeg;
  }
  frame.encoding = StereoFrame::ENCODING_JPEG;
  frame.left_size = static_cast<std::int32_t>(frame.left.size());
  frame.right_size = static_cast<std::int32_t>(frame.right.size());
  return frame;
}

}  // namespace markservo::mark_detector::test
