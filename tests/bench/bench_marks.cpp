#include "tests/bench/bench_marks.hpp"

#include "common/robot/configuration_error.hpp"

namespace markservo::bench {
namespace {

constexpr std::size_t kNumMarks = 3;

}  // namespace

std::vector<robot::MarkDescription> choose_marks(const robot::RobotDescription& robot, const std::string& file) {
  std::vector<robot::MarkDescription> marks;
  for (const robot::MarkDescription& mark : robot.marks) {
    if (marks.size() < kNumMarks && mark.surface == robot::MarkSurface::kPlane && mark.size > 0.0)
      marks.push_back(mark);
  }
  if (marks.size() == kNumMarks) return marks;
  throw ConfigurationError(file + ": marks: " + std::to_string(marks.size()) +
                           " flat ones with a size; allowed: 3 or more");
}

}  // namespace markservo::bench
