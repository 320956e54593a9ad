#include "services/mark-detector/learning/picture_assembly.hpp"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace markservo::mark_detector {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(PictureAssembly, IsCompleteWhenEachByteHasComeInWhateverOrder) {
  PictureAssembly picture(5);
  picture.add(3, {4, 5});
  picture.add(0, {1, 2});
  EXPECT_FALSE(picture.complete());
  picture.add(2, {3});
  EXPECT_TRUE(picture.complete());
  EXPECT_EQ(picture.take(), (Bytes{1, 2, 3, 4, 5}));
}

TEST(PictureAssembly, TakesAPieceThatComesAgainForOne) {
  PictureAssembly picture(4);
  picture.add(0, {1, 2});
  picture.add(0, {1, 2});
  EXPECT_FALSE(picture.complete());
  picture.add(1, {2, 3, 4});
  EXPECT_TRUE(picture.complete());
}

TEST(PictureAssembly, RefusesAPieceThatReachesOutOfThePicture) {
  PictureAssembly picture(4);
  EXPECT_THROW(picture.add(3, {1, 2}), std::out_of_range);
  EXPECT_THROW(picture.add(5, {1}), std::out_of_range);
  EXPECT_THROW(picture.add(~std::size_t{0}, {1}), std::out_of_range);
  EXPECT_THROW(picture.add(0, Bytes(5)), std::out_of_range);
}

}  // namespace
}  // namespace markservo::mark_detector
