#pragma once

// Tests that run once for every vector instruction set that this processor has and Highway's code was compiled for.

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <cstdint>
#include <string>
#include <vector>

namespace markservo::test {

class VectorTargetTest : public testing::TestWithParam<std::int64_t> {
 protected:
  VectorTargetTest() { hwy::SetSupportedTargetsForTest(GetParam()); }
  ~VectorTargetTest() override { hwy::SetSupportedTargetsForTest(0); }
};

inline auto every_vector_target() {
  std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();
  // To Highway ARM's NEON comes with AES. A processor without it (Raspberry Pi 3 and 4) has none of the targets then,
  // and gets what the compiler may assume, which is NEON.
  if (targets.empty()) targets.push_back(HWY_STATIC_TARGET);
  return testing::ValuesIn(targets);
}

inline std::string vector_target_name(const testing::TestParamInfo<std::int64_t>& target) {
  return hwy::TargetName(target.param);
}

}  // namespace markservo::test
