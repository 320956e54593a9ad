// After the first frames the detector asks for no memory.

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "services/mark-detector/mark_detector.hpp"
#include "tests/unit/allocation_count.hpp"
#include "tests/unit/mark-detector/synthetic_scene.hpp"

namespace markservo::mark_detector {
namespace {

struct Frame {
  test::Picture left{640, 480, test::kGrey};
  test::Picture right{640, 480, test::kGrey};

  Input input() const {
    return {left.view(), right.view(), geometry::StereoCamera{784.0, 784.0, 319.5, 319.5, 239.5, 0.065}};
  }
};

// Two marks that move, one of them too large for a patch of whole pixels, among specks of their colours.
std::vector<Frame> moving_marks() {
  std::vector<Frame> frames(10);
  for (std::size_t k = 0; k < frames.size(); ++k) {
    const double moved = 5.0 * static_cast<double>(k);
    for (const bool is_right : {false, true}) {
      test::Picture& picture = is_right ? frames[k].right : frames[k].left;
      picture.draw({320.0 + moved - (is_right ? 204.0 : 0.0), 150.0, 78.5, 0.1, test::kRed, 0.1});
      picture.draw({480.0 - moved - (is_right ? 340.0 : 0.0), 330.0, 130.8, 0.0, test::kBlue, 0.1});
      picture.fill(20 + 3 * static_cast<int>(k), 440, 12, 12, test::kRed);
      picture.expose(1.0, 3.0, static_cast<unsigned>(2 * k) + (is_right ? 1U : 0U));
    }
  }
  return frames;
}

TEST(MarkDetector, AsksForNoMemoryAfterTheFirstFrames) {
  std::vector<robot::MarkDescription> marks(2);
  marks[0].name = "a_mark_with_a_name_longer_than_strings_keep_in_themselves";
  marks[0].size = 0.025;
  marks[0].colour = {345.0, 15.0, 0.45, 1.0, 0.2, 1.0};
  marks[1] = marks[0];
  marks[1].name = "blue";
  marks[1].colour = {200.0, 245.0, 0.45, 1.0, 0.2, 1.0};
  const std::vector<Frame> frames = moving_marks();
  for (const int full_scan_every : {1, 5}) {
    Parameters parameters;
    parameters.search.full_scan_every = full_scan_every;
    const MarkDetector detector(marks, parameters);
    State state;
    for (int pass = 0; pass < 3; ++pass) {
      for (const Frame& frame : frames) {
        const Input input = frame.input();
        const auto step = [&] { detector.step(input, state); };
        const std::size_t bytes = markservo::test::peak_bytes(std::ref(step));
        for (const Finding& finding : state.output.marks) ASSERT_EQ(finding.reason, "") << finding.name;
        if (pass < 2) continue;
        EXPECT_EQ(bytes, 0U) << "searching everything every " << full_scan_every << " frames";
      }
    }
  }
}

}  // namespace
}  // namespace markservo::mark_detector
