#include "services/task-manager/procedure_types.hpp"

namespace markservo::task_manager {

std::string describe_sight(const MarkReport& mark) {
  std::string subject = "the mark of " + mark.name + " ";
  switch (mark.sight) {
    case Sight::kLocated:
      return subject + "is located";
    case Sight::kUnseen:
      return subject + "is seen by neither camera";
    case Sight::kSeenByOne:
      return subject + "is seen by one camera only";
    case Sight::kClipped:
      return subject + "is cut by an image border";
    case Sight::kTooFewMatches:
      return subject + "is seen, but too few of its points match";
    case Sight::kInconsistent:
      return subject + "is seen, but its two views do not fit together";
    case Sight::kUntold:
      return subject + "is not reported by target-locator";
  }
  return subject;
}

}  // namespace markservo::task_manager
