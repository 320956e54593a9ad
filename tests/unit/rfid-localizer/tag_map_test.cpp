#include "services/rfid-localizer/tag_map.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "tests/unit/rfid-localizer/tag_lattice.hpp"

namespace markservo::rfid_localizer {
namespace {

using test::lattice;
using test::uid_of;

// Tags anywhere in 10 x 10 m around the origin.
robot::TagField scattered(int number) {
  std::mt19937_64 bits(5);
  std::uniform_real_distribution<double> place(-5.0, 5.0);
  robot::TagField field;
  for (int i = 0; i < number; ++i) field.tags.push_back({uid_of(i), {place(bits), place(bits)}});
  return field;
}

std::vector<int> brute_force(const robot::TagField& field, const Eigen::Vector2d& p, double radius) {
  std::vector<int> tags;
  for (std::size_t i = 0; i < field.tags.size(); ++i) {
    if ((field.tags[i].p_W - p).norm() <= radius) tags.push_back(static_cast<int>(i));
  }
  return tags;
}

TEST(TagMap, FindsTheSameTagsInTheSameOrderAsALookAtEachOfThem) {
  const robot::TagField field = scattered(2000);
  const TagMap map(field, 0.1);
  std::mt19937_64 bits(6);
  std::uniform_real_distribution<double> place(-6.0, 6.0);
  std::uniform_real_distribution<double> size(0.0, 1.5);
  std::vector<int> tags{17};  // what was there before goes
  std::size_t found = 0;
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector2d p(place(bits), place(bits));
    const double radius = size(bits);
    map.near(p, radius, tags);
    ASSERT_EQ(tags, brute_force(field, p, radius)) << p.transpose() << " within " << radius;
    found += tags.size();
  }
  EXPECT_GT(found, 10'000U);
}

TEST(TagMap, GivesEachTagsPlaceAndNumberByItsUid) {
  const robot::TagField field = lattice(4, 3, 0.1);
  const TagMap map(field, 0.1);
  EXPECT_EQ(map.size(), 12U);
  for (int i = 0; i < 12; ++i) {
    ASSERT_EQ(map.find(uid_of(i)), i);
    EXPECT_EQ(map.position(i), field.tags[static_cast<std::size_t>(i)].p_W);
  }
}

TEST(TagMap, DoesNotKnowAUidThatItDoesNotHave) {
  const TagMap map(lattice(4, 3, 0.1), 0.1);
  EXPECT_FALSE(map.find(uid_of(12)));
  EXPECT_FALSE(map.find(""));
  EXPECT_FALSE(map.find("e004015000000001")) << "uids are upper case";
}

TEST(TagMap, HasNothingNearPlacesFarOffTheFloor) {
  const TagMap map(lattice(4, 3, 0.1), 0.1);
  std::vector<int> tags;
  for (const double far : {1e3, -1e9, 1e15, -1e300}) {
    map.near({far, 0.0}, 0.5, tags);
    EXPECT_TRUE(tags.empty()) << far;
    map.near({0.0, far}, 0.5, tags);
    EXPECT_TRUE(tags.empty()) << far;
  }
}

TEST(TagMap, RefusesAnEmptyField) {
  EXPECT_THROW(TagMap(robot::TagField{"bare", {}}, 0.1), std::invalid_argument);
}

// A robot that does not know where it is asks so: the answer must not take as long as the cells are many.
TEST(TagMap, FindsAllTagsWithinAnyRadiusAtOnce) {
  const robot::TagField field = lattice(4, 3, 0.1);
  const TagMap map(field, 0.1);
  std::vector<int> tags;
  for (const double radius : {10.0, 1e5, 1e12, std::numeric_limits<double>::infinity()}) {
    map.near({0.0, 0.0}, radius, tags);
    EXPECT_EQ(tags, brute_force(field, {0.0, 0.0}, radius)) << radius;
    EXPECT_EQ(tags.size(), 12U) << radius;
  }
}

}  // namespace
}  // namespace markservo::rfid_localizer
