#include "services/recorder/folder/part_names.hpp"

#include <gtest/gtest.h>

namespace markservo::recorder {
namespace {

using Names = std::vector<std::string>;

std::vector<Part> parts_of(const Names& names, std::int64_t bytes = 1) {
  std::vector<Part> parts;
  for (const std::string& name : names) parts.push_back({name, bytes});
  return parts;
}

Names names_of(const std::vector<Part>& parts) {
  Names names;
  for (const Part& part : parts) names.push_back(part.name);
  return names;
}

TEST(PartNames, AreInTheOrderInWhichTheyWereWritten) {
  EXPECT_EQ(names_of(parts_in_order(parts_of({"log.lcm.100", "log.lcm.02", "log.lcm.99", "log.lcm"}))),
            (Names{"log.lcm", "log.lcm.02", "log.lcm.99", "log.lcm.100"}));
}

TEST(PartNames, LeaveOutWhatIsNoPart) {
  EXPECT_EQ(names_of(parts_in_order(parts_of({"manifest.json", "log.lcm.fixed", "log.lcm.", "log.lcm.-1", "log.lcm.0x1",
                                              "my-log.lcm", "log.lcm.01"}))),
            Names{"log.lcm.01"});
}

TEST(PartsToRemove, AreAllButTheNewest) {
  const std::vector<Part> parts = parts_of({"log.lcm.07", "log.lcm.08", "log.lcm.09"});
  EXPECT_EQ(parts_to_remove(parts, 1), (Names{"log.lcm.07", "log.lcm.08"}));
  EXPECT_EQ(parts_to_remove(parts, 3), Names{});
  EXPECT_EQ(parts_to_remove(parts, 9), Names{});
}

TEST(NextPart, HasTheNumberOfItsLogger) {
  EXPECT_EQ(next_part({}, false, 0).file, "log.lcm");
  EXPECT_EQ(next_part(parts_of({"log.lcm"}), false, 1).file, "log.lcm.01");
  EXPECT_EQ(next_part({}, false, 100).file, "log.lcm.100");
}

// lcm-logger numbers by itself, from the first name that is free.
TEST(NextPart, ComesBehindThoseThatWereRemovedWhereTheLoggerNumbersThem) {
  const NextPart first = next_part({}, true, 0);
  EXPECT_EQ(first.file, "log.lcm");
  EXPECT_EQ(first.places_to_hold, Names{});
  const NextPart next = next_part(parts_of({"log.lcm.02", "log.lcm.03"}), true, 1);
  EXPECT_EQ(next.file, "log.lcm");
  EXPECT_EQ(next.places_to_hold, (Names{"log.lcm.00", "log.lcm.01"}));
}

TEST(HeldPlaces, AreEmptyAndNotTheNewest) {
  std::vector<Part> parts = parts_of({"log.lcm.00", "log.lcm.01"}, 0);
  parts.push_back({"log.lcm.02", 7});
  parts.push_back({"log.lcm.03", 0});
  EXPECT_EQ(held_places(parts), (Names{"log.lcm.00", "log.lcm.01"}));
  EXPECT_EQ(held_places(parts_of({"log.lcm"}, 0)), Names{});
}

}  // namespace
}  // namespace markservo::recorder
