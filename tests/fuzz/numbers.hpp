#pragma once

// Numbers that break arithmetic, drawn from the fuzzer's bytes. Without bytes left every one is its usual value.

#include <fuzzer/FuzzedDataProvider.h>

#include <limits>

namespace markservo::fuzz {

inline double extreme_number(FuzzedDataProvider& data) {
  using Limits = std::numeric_limits<double>;
  return data.PickValueInArray({0.0,
                                -0.0,
                                1.0,
                                -1.0,
                                0.5,
                                1e-9,
                                1e9,
                                -1e9,
                                2147483648.0,
                                -2147483649.0,
                                1e19,
                                1e154,
                                1e300,
                                -1e300,
                                Limits::max(),
                                Limits::lowest(),
                                Limits::min(),
                                Limits::denorm_min(),
                                Limits::epsilon(),
                                Limits::infinity(),
                                -Limits::infinity(),
                                Limits::quiet_NaN()});
}

// Mostly as it should be, else near it, else anything at all.
inline double number(FuzzedDataProvider& data, double usual, double least, double most) {
  switch (data.ConsumeIntegralInRange(0, 7)) {
    case 6:
      return data.ConsumeFloatingPointInRange(least, most);
    case 7:
      return extreme_number(data);
    default:
      return usual;
  }
}

}  // namespace markservo::fuzz
