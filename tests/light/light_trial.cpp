#include "tests/light/light_trial.hpp"

#include <algorithm>
#include <cmath>

namespace markservo::light {
namespace {

// A mark of 60 px half of which is classified is found a quarter of that off; a thing elsewhere is further away.
constexpr double kFound_px = 12.0;

bool is_at(const mark_detector::Finding& finding, const MarkPlace& mark) {
  return std::hypot(finding.left.shape.u - mark.u_left, finding.left.shape.v - mark.v) < kFound_px &&
         std::hypot(finding.right.shape.u - mark.u_right, finding.right.shape.v - mark.v) < kFound_px;
}

// In either image: what is seen by one alone is no measurement, but no other mark either.
bool is_at_another(const mark_detector::Finding& finding, const std::vector<MarkPlace>& marks, std::size_t own) {
  for (std::size_t i = 0; i < marks.size(); ++i) {
    if (i == own || !marks[i].visible) continue;
    const auto near = [&](const mark_detector::View& view, double u) {
      return view.seen && std::hypot(view.shape.u - u, view.shape.v - marks[i].v) < kFound_px;
    };
    if (near(finding.left, marks[i].u_left) || near(finding.right, marks[i].u_right)) return true;
  }
  return false;
}

}  // namespace

Trial run_trial(LightScene& scene, const std::vector<LightFrame>& sequence,
                const std::vector<robot::MarkDescription>& marks, const mark_detector::Parameters& parameters) {
  const mark_detector::MarkDetector detector(marks, parameters);
  mark_detector::State state;
  Trial trial;
  for (const auto& mark : marks) trial.marks.push_back({mark.name});
  std::vector<int> lost(marks.size(), 0);
  for (std::size_t k = 0; k < sequence.size(); ++k) {
    const Frame& frame = scene.expose(sequence[k], static_cast<int>(k));
    const mark_detector::Output output = detector.step(frame.input(scene.camera()), state);
    for (std::size_t i = 0; i < marks.size(); ++i) {
      const mark_detector::Finding& finding = output.marks[i];
      MarkScore& score = trial.marks[i];
      const bool seen = finding.left.seen && finding.right.seen;
      const bool found = seen && is_at(finding, frame.marks[i]);
      score.wrong += seen && !found ? 1 : 0;
      score.confused += is_at_another(finding, frame.marks, i) ? 1 : 0;
      if (!frame.marks[i].visible) {
        lost[i] = 0;
        continue;
      }
      ++score.visible;
      score.found += found ? 1 : 0;
      lost[i] = found ? 0 : lost[i] + 1;
      score.longest_lost = std::max(score.longest_lost, lost[i]);
      if (found) score.least_separability = std::min(score.least_separability, finding.separability);
    }
  }
  return trial;
}

}  // namespace markservo::light
