#pragma once

// What most files include, compiled once in a build (CMake option MARKSERVO_PRECOMPILE). A file includes what it uses
// as if this were not there: the sanitizers' builds and clang-tidy do without it.

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>
