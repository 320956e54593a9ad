#pragma once

// What the laws remember of the goal between frames; each uses its own part.

#include "services/visual-servo/laws/paper_law.hpp"
#include "services/visual-servo/laws/servo_by_sight.hpp"

namespace markservo::visual_servo {

struct LawState {
  SightState sight;
  PaperState paper;

  // Another goal, or an arm that was taken up anew.
  void forget() { *this = LawState(); }
  // Pictures of another writer: what was learned by sight is forgotten. The paper's law learns nothing.
  void forget_pictures() { sight = SightState(); }
  // Hand or target is not seen now: nothing is averaged over that. The paper's law counts on when they are back.
  void lose_sight() { sight.window.forget(); }
  // The goal's sender is silent, so that nothing is done for it now.
  void interrupt() {
    sight.window.forget();
    paper = PaperState();
  }
};

}  // namespace markservo::visual_servo
