#include "services/mark-detector/adaptation/colour_model.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace markservo::mark_detector {
namespace {

constexpr int kWidth = 160;
constexpr int kHeight = 120;
constexpr int kMark = 40;  // px, edge
constexpr int kMark_u = 20;
constexpr int kMark_v = 30;
constexpr int kChromaMin = 14;
const Bgr kDaylight{1.0, 1.0, 1.0};
const Bgr kYellow{39.0, 189.0, 200.0};
const robot::ColourInterval kYellowHues{40.0, 72.0, 0.45, 1.0, 0.25, 1.0};
const robot::ColourInterval kGreenHues{95.0, 150.0, 0.40, 1.0, 0.15, 1.0};

robot::MarkDescription mark_of(const robot::ColourInterval& interval) {
  robot::MarkDescription mark;
  mark.colour = interval;
  return mark;
}

double hue_of(const Bgr& colour, const Bgr& light) {
  return hsv_of({colour[0] * light[0], colour[1] * light[1], colour[2] * light[2]}).hue_deg;
}

// A model, fed with pictures of one mark before a grey wall.
class ModelInLight : public ::testing::Test {
 protected:
  // The intervals in use in a frame; the mark, if there is one, is seen in it.
  const std::vector<robot::ColourInterval>& frame(const ColourModel& model, const Bgr& light,
                                                  const Bgr* mark = nullptr) {
    pixels_.clear();
    for (int v = 0; v < kHeight; ++v) {
      for (int u = 0; u < kWidth; ++u) {
        const bool in_mark = u >= kMark_u && u < kMark_u + kMark && v >= kMark_v && v < kMark_v + kMark;
        const double print = 0.5 + 0.125 * ((u / 4 + v / 4) % 5);
        for (std::size_t c = 0; c < 3; ++c) {
          const double level = in_mark && mark != nullptr ? print * (*mark)[c] : 160.0 * print;
          pixels_.push_back(static_cast<std::uint8_t>(std::min(255L, std::lround(light[c] * level))));
        }
      }
    }
    const ImageView image{pixels_.data(), kWidth, kHeight, 3 * kWidth};
    model.rules(image, state_);
    if (mark != nullptr) {
      std::vector<PixelRun> runs;
      for (int v = kMark_v; v < kMark_v + kMark; ++v) runs.push_back({v, kMark_u, kMark_u + kMark});
      Region region;
      make_region(runs, shape_of(runs), 0, kWidth, kHeight, region);
      accepted_ = model.observe(0, image, region, image, region, state_);
    }
    return state_.intervals;
  }

  ColourState state_;
  bool accepted_ = false;

 private:
  std::vector<std::uint8_t> pixels_;
};

void expect_equal(const robot::ColourInterval& a, const robot::ColourInterval& b) {
  EXPECT_NEAR(a.hue_min_deg, b.hue_min_deg, 1e-3);
  EXPECT_NEAR(a.hue_max_deg, b.hue_max_deg, 1e-3);
  EXPECT_NEAR(a.saturation_min, b.saturation_min, 1e-3);
  EXPECT_NEAR(a.value_min, b.value_min, 1e-3);
}

TEST_F(ModelInLight, LeavesAnIntervalInWhichTheMarkLiesWell) {
  const ColourModel model({mark_of(kYellowHues)}, kChromaMin);
  for (int i = 0; i < 10; ++i) expect_equal(frame(model, kDaylight, &kYellow)[0], kYellowHues);
  EXPECT_TRUE(accepted_);
}

TEST_F(ModelInLight, TurnsTheIntervalWithTheLightInTheSameFrame) {
  const ColourModel model({mark_of(kYellowHues)}, kChromaMin);
  frame(model, kDaylight, &kYellow);
  const Bgr greenish{0.85, 1.15, 0.85};
  const robot::ColourInterval& used = frame(model, greenish, &kYellow)[0];
  const double hue = hue_of(kYellow, greenish);
  EXPECT_GT(hue, kYellowHues.hue_max_deg) << "else this light is no test";
  EXPECT_GT(used.hue_max_deg, hue + 5.0);
  EXPECT_GT(used.hue_min_deg, kYellowHues.hue_min_deg) << "the other end follows";
  EXPECT_LT(used.hue_min_deg, hue - 5.0);
}

TEST_F(ModelInLight, TakesPalerColoursAndTurnedHuesWhereLightClips) {
  const Bgr blue{190.0, 84.0, 38.0};
  const ColourModel model({mark_of({200.0, 245.0, 0.60, 1.0, 0.15, 1.0})}, kChromaMin);
  frame(model, kDaylight, &blue);
  const robot::ColourInterval& used = frame(model, {2.5, 2.5, 2.5}, &blue)[0];
  const Hsv brightest = hsv_of({255.0, 2.5 * 84.0, 2.5 * 38.0});
  EXPECT_LT(used.hue_min_deg, brightest.hue_deg);
  EXPECT_LT(used.saturation_min, brightest.saturation);
}

TEST_F(ModelInLight, FollowsASlowChangeThatTheImageDoesNotShow) {
  // Only the mark's own colour fades towards green, as in a lamp's corner.
  const ColourModel model({mark_of(kYellowHues)}, kChromaMin);
  Bgr colour = kYellow;
  for (int i = 0; i < 60; ++i) {
    colour[2] *= 0.995;
    frame(model, kDaylight, &colour);
    ASSERT_TRUE(accepted_) << i;
  }
  EXPECT_GT(state_.intervals[0].hue_max_deg, hue_of(colour, kDaylight) + 5.0);
}

TEST_F(ModelInLight, KeepsMarksApartWhateverTheLight) {
  const ColourModel model({mark_of(kYellowHues), mark_of(kGreenHues)}, kChromaMin);
  for (const Bgr& light : {Bgr{0.85, 1.15, 0.6}, Bgr{1.15, 1.15, 0.4}, Bgr{0.6, 0.85, 1.15}, Bgr{2.0, 2.5, 2.5}}) {
    state_ = {};
    frame(model, kDaylight, &kYellow);
    for (int i = 0; i < 5; ++i) {
      const auto& used = frame(model, light, &kYellow);
      EXPECT_LT(used[0].hue_max_deg + 1.0, used[1].hue_min_deg);
      EXPECT_GT(wrapped(used[1].hue_max_deg - used[1].hue_min_deg), 10.0);
    }
  }
}

TEST_F(ModelInLight, NeverTurnsMarksOfOneHueThatValueOrSaturationTellApart) {
  const robot::ColourInterval bright{40.0, 72.0, 0.45, 1.0, 0.60, 1.0};
  const robot::ColourInterval dark{40.0, 72.0, 0.45, 1.0, 0.10, 0.55};
  const ColourModel model({mark_of(bright), mark_of(dark)}, kChromaMin);
  frame(model, kDaylight, &kYellow);
  const auto& used = frame(model, {0.4, 0.4, 0.4}, &kYellow);
  expect_equal(used[0], bright);
  EXPECT_DOUBLE_EQ(used[1].value_max, dark.value_max);
}

TEST_F(ModelInLight, RefusesAThingOfAnotherHueAndLearnsNothingFromIt) {
  const ColourModel model({mark_of(kYellowHues)}, kChromaMin);
  frame(model, kDaylight, &kYellow);
  frame(model, kDaylight, &kYellow);
  const Bgr before = state_.marks[0].mean;
  const Bgr amber{39.0, 150.0, 200.0};
  frame(model, kDaylight, &amber);
  EXPECT_FALSE(accepted_);
  EXPECT_NEAR(hsv_of(state_.marks[0].mean).hue_deg, hsv_of(before).hue_deg, 0.5);
}

TEST_F(ModelInLight, ForgetsTheLightOfAMarkThatIsNotSeenForLong) {
  ColourModelParameters parameters;
  parameters.memory_frames = 20;
  const ColourModel model({mark_of(kYellowHues)}, kChromaMin, parameters);
  const Bgr greenish{0.85, 1.15, 0.85};
  frame(model, kDaylight, &kYellow);
  frame(model, greenish, &kYellow);
  for (int i = 0; i < 10; ++i) frame(model, greenish);
  EXPECT_GT(state_.intervals[0].hue_max_deg, kYellowHues.hue_max_deg) << "predicted for a while";
  for (int i = 0; i < 200; ++i) frame(model, greenish);
  expect_equal(state_.intervals[0], kYellowHues);
}

TEST_F(ModelInLight, LeavesEveryHueAlone) {
  const robot::ColourInterval dark{0.0, 360.0, 0.0, 1.0, 0.0, 0.2};
  const ColourModel model({mark_of(dark)}, kChromaMin);
  frame(model, kDaylight, &kYellow);
  expect_equal(frame(model, {0.85, 1.15, 0.85}, &kYellow)[0], dark);
}

}  // namespace
}  // namespace markservo::mark_detector
