#include "services/mark-detector/mark_option.hpp"

#include <gtest/gtest.h>

#include "common/robot/configuration_error.hpp"

namespace markservo::mark_detector {
namespace {

TEST(MarkOption, DescribesAMark) {
  const robot::MarkDescription mark = parse_mark("red=345:15:0.5:1:0.2:0.9");
  EXPECT_EQ(mark.name, "red");
  EXPECT_EQ(mark.colour.hue_min_deg, 345.0);
  EXPECT_EQ(mark.colour.hue_max_deg, 15.0);
  EXPECT_EQ(mark.colour.saturation_min, 0.5);
  EXPECT_EQ(mark.colour.value_max, 0.9);
  EXPECT_EQ(mark.surface, robot::MarkSurface::kPlane);
  EXPECT_EQ(parse_mark("leaves=60:160:0.2:1:0.1:1:free").surface, robot::MarkSurface::kFree);
}

TEST(MarkOption, RefusesWhatIsNoInterval) {
  for (const char* text : {"", "red", "=1:2:0:1:0:1", "red=1:2:0:1:0", "red=1:2:0:1:0:1:soft", "red=1:2:0:1:0:1:free:x",
                           "red=1:x:0:1:0:1", "red=1:400:0:1:0:1", "red=-1:2:0:1:0:1", "red=1:2:0:1.5:0:1",
                           "red=1:2:nan:1:0:1", "red=1:2:0.9:0.1:0:1", "red=1:2:0:1:0.5:0.1", "a/b=1:2:0:1:0:1"}) {
    EXPECT_THROW(parse_mark(text), ConfigurationError) << text;
  }
}

}  // namespace
}  // namespace markservo::mark_detector
