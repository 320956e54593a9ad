#pragma once

namespace markservo {

// What carries a located mark's position, as LocatedMark.lcm numbers and explains it.
enum class MarkCue { kNone, kTexture, kOutline, kCentroid };

// What the mark is measured by, for a person: "by its texture", ...; "by nothing" for none.
const char* name_of(MarkCue cue);

}  // namespace markservo
