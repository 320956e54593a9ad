#pragma once

// What the laws remember of the goal between frames; each uses its own part.

#include "services/visual-servo/laws/paper_law.hpp"
#include "services/visual-servo/laws/servo_by_sight.hpp"

namespace markservo::visual_servo {

struct LawState {
  SightState sight;
  PaperState paper;

  // To be called when the arm is taken up anew.
  void begin_anew() { *this = LawState(); }
  // To be called for another goal. What was learned of the arm by sight stays true.
  void forget() {
    const KinematicBias bias = sight.bias;
    begin_anew();
    sight.bias = bias;
  }
  // To be called when the pictures are of another writer: what was learned by sight is forgotten. The paper's law
  // learns nothing.
  void forget_pictures() { sight = SightState(); }
  // To be called when hand or target is not seen: nothing is averaged over that. The paper's law counts on when both
  // are back.
  void lose_sight() { sight.window.forget(); }
  // To be called while the goal's sender is silent, so that nothing is done for the goal.
  void interrupt() {
    sight.window.forget();
    paper = PaperState();
  }
};

}  // namespace markservo::visual_servo
