#include "common/states/mark_status.hpp"

namespace markservo {

const char* name_of(MarkStatus status) {
  switch (status) {
    case MarkStatus::kLocated:
      return "located";
    case MarkStatus::kUnseen:
      return "seen by neither camera";
    case MarkStatus::kSeenByOne:
      return "seen by one camera only";
    case MarkStatus::kClipped:
      return "cut by an image border";
    case MarkStatus::kTooFewMatches:
      return "seen, but neither its texture nor its outline tells where";
    case MarkStatus::kInconsistent:
      return "seen, but its two views do not fit together";
  }
  return "of unknown status";
}

}  // namespace markservo
