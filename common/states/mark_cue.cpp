#include "common/states/mark_cue.hpp"

namespace markservo {

const char* name_of(MarkCue cue) {
  switch (cue) {
    case MarkCue::kNone:
      return "by nothing";
    case MarkCue::kTexture:
      return "by its texture";
    case MarkCue::kOutline:
      return "by its outline";
    case MarkCue::kCentroid:
      return "by the middle of its colour";
  }
  return "by an unknown cue";
}

}  // namespace markservo
