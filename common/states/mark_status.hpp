#pragma once

namespace markservo {

// Whether and why not a mark is located, as LocatedMark.lcm numbers and explains it.
enum class MarkStatus { kLocated, kUnseen, kSeenByOne, kClipped, kTooFewMatches, kInconsistent };

// What the mark is, for a person: "located", "seen by neither camera", ...
const char* name_of(MarkStatus status);

}  // namespace markservo
