#pragma once

// Whether an arm that rests elsewhere than it is told to is taken where it is. While nothing is to move that is done
// once only: an arm that sags, or a report that is wrong, would lead it on without end.

namespace markservo::visual_servo {

class LostArm {
 public:
  // To be called for another goal: the arm may be taken where it is once more.
  void forget() { taken_in_hold_ = false; }
  // The arm rests elsewhere: whether its place is to be adopted. `holds`: nothing is to move.
  bool adopts(bool holds) {
    if (holds && taken_in_hold_) return false;
    taken_in_hold_ = holds;
    return true;
  }

 private:
  bool taken_in_hold_ = false;
};

}  // namespace markservo::visual_servo
