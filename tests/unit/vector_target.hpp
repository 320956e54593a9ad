#pragma once

// Tests that run once for every vector instruction set that this processor has and Highway's code was compiled for.

#include <gtest/gtest.h>

#include <hwy/targets.h>
#include <cstdint>
#include <string>

namespace markservo::test {

class VectorTargetTest : public testing::TestWithParam<std::int64_t> {
 protected:
  VectorTargetTest() { hwy::SetSupportedTargetsForTest(GetParam()); }
  ~VectorTargetTest() override { hwy::SetSupportedTargetsForTest(0); }
};

inline auto every_vector_target() {
  return testing::ValuesIn(hwy::SupportedAndGeneratedTargets());
}

inline std::string vector_target_name(const testing::TestParamInfo<std::int64_t>& target) {
  return hwy::TargetName(target.param);
}

}  // namespace markservo::test
