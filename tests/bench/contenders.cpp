#include "tests/bench/contenders.hpp"

#include <benchmark/benchmark.h>
#include <hwy/highway.h>
#include <hwy/targets.h>

#include <algorithm>

#include "tests/bench/apriltag_reference.hpp"
#include "tests/bench/baseline_at.hpp"
#include "tests/bench/opencv_references.hpp"
#include "tests/bench/ours.hpp"
#include "tests/bench/read_once.hpp"

namespace markservo::bench {
namespace {

constexpr int kAllPairs = 64;
constexpr int kSomePairs = 16;  // of what takes tens of ms

class List {
 public:
  explicit List(const std::vector<scenes::StereoPair>& pairs) : pairs_(pairs) {}

  // `call` takes a pair.
  template <class Call>
  void add(const std::string& name, int calls, Call call, std::int64_t vector_target = 0) {
    const auto& pairs = pairs_;
    contenders_.push_back({name, calls, [&pairs, call](std::size_t i) { call(pairs[i]); }, vector_target});
  }
  // `call` takes a pair's number.
  template <class Call>
  void add_numbered(const std::string& name, int calls, Call call) {
    contenders_.push_back({name, calls, call});
  }
  std::vector<Contender> take() { return std::move(contenders_); }

 private:
  const std::vector<scenes::StereoPair>& pairs_;
  std::vector<Contender> contenders_;
};

// The stages, each given what the ones before it made of the same pair.
void add_stages(const std::vector<scenes::StereoPair>& pairs, const std::shared_ptr<Ours>& ours, List& list) {
  auto shifts = std::make_shared<std::vector<mark_detector::LumaShift>>();
  auto detections = std::make_shared<std::vector<mark_detector::Output>>();
  for (const scenes::StereoPair& pair : pairs) {
    shifts->push_back(ours->equalise(pair));
    detections->push_back(ours->detect(pair));
  }
  list.add(names::kDetect, kAllPairs,
           [ours](const scenes::StereoPair& pair) { benchmark::DoNotOptimize(ours->detect(pair).marks.data()); });
  list.add(names::kEqualise, kAllPairs,
           [ours](const scenes::StereoPair& pair) { benchmark::DoNotOptimize(ours->equalise(pair)[0]); });
  list.add_numbered(names::kClassify, kAllPairs,
                    [ours, shifts, &pairs](std::size_t i) { ours->classify(pairs[i], (*shifts)[i]); });
  list.add_numbered(names::kLocate, kAllPairs, [ours, detections](std::size_t i) {
    benchmark::DoNotOptimize(ours->locate((*detections)[i]).data());
  });
  // An instance of its own, so that the masks stay those of the first pair.
  auto labeller = std::make_shared<Ours>(*ours);
  labeller->classify(pairs.front(), shifts->front());
  list.add_numbered(names::kLabel, kAllPairs,
                    [labeller](std::size_t /*i*/) { benchmark::DoNotOptimize(labeller->label()); });
}

void add_references(const std::vector<scenes::StereoPair>& pairs, const std::vector<robot::MarkDescription>& marks,
                    const geometry::StereoCamera& camera, List& list) {
  const auto opencv_chain = std::make_shared<BaselineAt>(marks, camera);
  list.add(names::kOpencvChain, kAllPairs, [opencv_chain](const scenes::StereoPair& pair) {
    benchmark::DoNotOptimize(opencv_chain->run(pair.left, pair.right).data());
  });
  const auto near = std::make_shared<BlockMatching>(112, 256);  // 139 to 455 mm
  list.add(names::kStereoBmNear, kSomePairs,
           [near](const scenes::StereoPair& pair) { benchmark::DoNotOptimize(near->run(pair.left, pair.right).data); });
  const auto usual = std::make_shared<BlockMatching>(0, 64);
  list.add(names::kStereoBm64, kSomePairs, [usual](const scenes::StereoPair& pair) {
    benchmark::DoNotOptimize(usual->run(pair.left, pair.right).data);
  });
  const auto flow = std::make_shared<CornersAndFlow>();
  list.add(names::kCornersAndFlow, kSomePairs,
           [flow](const scenes::StereoPair& pair) { benchmark::DoNotOptimize(flow->run(pair.left, pair.right)); });
  const auto tags = std::make_shared<TagSearch>();
  list.add(names::kAprilTag, kSomePairs,
           [tags](const scenes::StereoPair& pair) { benchmark::DoNotOptimize(tags->run(pair.left, pair.right)); });
  list.add(names::kColdRead, kAllPairs,
           [](const scenes::StereoPair& pair) { benchmark::DoNotOptimize(read_once(pair.left, pair.right)); });
  list.add_numbered(names::kHotRead, kAllPairs, [&pairs](std::size_t /*i*/) {
    benchmark::DoNotOptimize(read_once(pairs.front().left, pairs.front().right));
  });
}

}  // namespace

VectorTargets vector_targets() {
  std::vector<std::int64_t> targets = hwy::SupportedAndGeneratedTargets();  // the lower the better
  if (targets.empty()) targets.push_back(HWY_STATIC_TARGET);                // ARM without AES: plain NEON
  VectorTargets result;
  result.best = *std::min_element(targets.begin(), targets.end());
  result.portable = *std::max_element(targets.begin(), targets.end());
  if (std::find(targets.begin(), targets.end(), std::int64_t{HWY_AVX2}) != targets.end()) result.avx2 = HWY_AVX2;
  return result;
}

std::vector<Contender> make_contenders(const std::vector<scenes::StereoPair>& pairs,
                                       const std::vector<robot::MarkDescription>& marks,
                                       const geometry::StereoCamera& camera) {
  List list(pairs);
  const auto add_ours = [&](const char* name, Scan scan, std::int64_t vector_target) {
    const auto ours = std::make_shared<Ours>(marks, camera, scan);
    list.add(
        name, kAllPairs,
        [ours](const scenes::StereoPair& pair) { benchmark::DoNotOptimize(ours->run(pair).locations.data()); },
        vector_target);
  };
  const VectorTargets targets = vector_targets();
  add_ours(names::kOurs, Scan::kWholeImage, 0);
  add_ours(names::kTracked, Scan::kTracked, 0);
  if (targets.avx2 != 0) add_ours(names::kOursAvx2, Scan::kWholeImage, targets.avx2);
  add_ours(names::kOursPortable, Scan::kWholeImage, targets.portable);
  add_stages(pairs, std::make_shared<Ours>(marks, camera, Scan::kWholeImage), list);
  add_references(pairs, marks, camera, list);
  return list.take();
}

}  // namespace markservo::bench
