#pragma once

// Everything that is timed, by name.

#include <memory>
#include <string>
#include <vector>

#include "tests/bench/rounds.hpp"
#include "tests/scenes/stereo_scene.hpp"

namespace markservo::bench {

namespace names {
inline constexpr char kOurs[] = "ours";
inline constexpr char kTracked[] = "tracked";
inline constexpr char kOursAvx2[] = "ours_avx2";
inline constexpr char kOursPortable[] = "ours_portable";
inline constexpr char kDetect[] = "ours_detect";
inline constexpr char kEqualise[] = "ours_equalise";
inline constexpr char kClassify[] = "ours_classify";
inline constexpr char kLabel[] = "ours_label";
inline constexpr char kLocate[] = "ours_locate";
inline constexpr char kOpencvChain[] = "opencv_chain";
inline constexpr char kStereoBmNear[] = "stereobm_112_367";
inline constexpr char kStereoBm64[] = "stereobm_64";
inline constexpr char kCornersAndFlow[] = "corners_and_flow";
inline constexpr char kAprilTag[] = "apriltag";
inline constexpr char kColdRead[] = "cold_read";
inline constexpr char kHotRead[] = "hot_read";
}  // namespace names

// Vector instruction sets of Highway as this processor and the build have them.
struct VectorTargets {
  std::int64_t best = 0;
  std::int64_t avx2 = 0;  // 0: there is none
  std::int64_t portable = 0;
};
VectorTargets vector_targets();

// Those that this processor can run. `pairs` must outlive them.
std::vector<Contender> make_contenders(const std::vector<scenes::StereoPair>& pairs,
                                       const std::vector<robot::MarkDescription>& marks,
                                       const geometry::StereoCamera& camera);

}  // namespace markservo::bench
