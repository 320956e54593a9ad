// Every vector instruction set that this processor has gives the bits of the scalar definition.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "services/mark-detector/colour/colour_kernel.hpp"
#include "tests/unit/vector_target.hpp"

namespace markservo::mark_detector {
namespace {

class VectorTarget : public test::VectorTargetTest {
 protected:
  // Grey with coloured patches, like a scene; or every level anywhere.
  std::vector<std::uint8_t> random_row(int width, bool scene) {
    std::uniform_int_distribution<int> level(0, 255);
    std::normal_distribution<double> noise(0.0, 3.0);
    std::vector<std::uint8_t> row(static_cast<std::size_t>(3 * width));
    const int begin = level(random_) % width;
    const int colour[] = {level(random_), level(random_), level(random_)};
    for (std::size_t i = 0; i < row.size(); ++i) {
      const bool patch = static_cast<int>(i / 3) >= begin && static_cast<int>(i / 3) < begin + 70;
      const double base = patch ? colour[i % 3] : 120.0;
      row[i] = static_cast<std::uint8_t>(scene ? std::clamp(base + noise(random_), 0.0, 255.0) : level(random_));
    }
    return row;
  }

  std::mt19937 random_{11};
};

TEST_P(VectorTarget, ClassifiesAsTheDefinitionSays) {
  std::uniform_real_distribution<double> hue(0.0, 360.0);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  std::uniform_int_distribution<int> levels(-80, 255);
  std::int64_t inside = 0;
  for (int trial = 0; trial < 400; ++trial) {
    LumaShift shift{};
    for (auto& added : shift) added = static_cast<std::int16_t>(trial % 3 == 0 ? 0 : levels(random_));
    std::vector<ColourRule> rules;
    for (int k = 0; k < 1 + trial % 8; ++k) {
      const double value = 0.6 * share(random_);
      rules.push_back(make_rule({hue(random_), hue(random_), 0.6 * share(random_), 0.6 + 0.4 * share(random_), value,
                                 k % 2 == 0 ? 1.0 : value + 0.4 * share(random_)},
                                k % 3 == 0 ? 0 : 14));
    }
    const int width = 1 + trial;
    const std::vector<std::uint8_t> row = random_row(width, trial % 2 == 0);
    const std::size_t num_words = (static_cast<std::size_t>(width) + 63) / 64;
    std::vector<std::vector<std::uint64_t>> words(rules.size(),
                                                  std::vector<std::uint64_t>(num_words, ~std::uint64_t{0}));
    std::vector<std::uint64_t*> rows;
    for (auto& own : words) rows.push_back(own.data());
    std::vector<FrameRule> for_frame;
    frame_rules(rules, shift, for_frame);
    const std::uint32_t met = classify_row(row.data(), width, for_frame.data(), rules.size(), shift, rows.data());
    for (std::size_t k = 0; k < rules.size(); ++k) {
      bool any = false;
      for (std::size_t u = 0; u < 64 * num_words; ++u) {
        const std::uint8_t* p = row.data() + 3 * u;
        const bool expected =
            u < static_cast<std::size_t>(width) &&
            belongs(rules[k], p[0], p[1], p[2], shift[static_cast<std::size_t>(luma(p[0], p[1], p[2]))]);
        ASSERT_EQ(((words[k][u / 64] >> (u % 64)) & 1U) != 0, expected)
            << "trial " << trial << " rule " << k << " px " << u;
        inside += expected ? 1 : 0;
        any = any || expected;
      }
      EXPECT_EQ(((met >> k) & 1U) != 0, any) << "trial " << trial << " rule " << k;
    }
  }
  EXPECT_GT(inside, 10000);
}

TEST_P(VectorTarget, CountsEveryLuma) {
  for (const int width : {1, 3, 64, 65, 127, 640, 643}) {
    const std::vector<std::uint8_t> row = random_row(width, false);
    std::array<std::int64_t, 256> expected{};
    for (std::size_t u = 0; u < row.size(); u += 3)
      ++expected[static_cast<std::size_t>(luma(row[u], row[u + 1], row[u + 2]))];
    LumaCounts counts;
    count_luma_row(row.data(), width, counts);
    for (std::size_t i = 0; i < 256; ++i) {
      const auto& tables = counts.tables;
      ASSERT_EQ(std::int64_t{tables[0][i]} + tables[1][i] + tables[2][i] + tables[3][i], expected[i]) << "level " << i;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(OfThisProcessor, VectorTarget, test::every_vector_target(), test::vector_target_name);

}  // namespace
}  // namespace markservo::mark_detector
