#pragma once

// The time of the pictures: which was acted on last, and how much time a step may fill.

#include <cstdint>

#include "services/visual-servo/servo_types.hpp"

namespace markservo::visual_servo {

// How a picture stands to the one before.
enum class Succession {
  kNext,
  kAfterAGap,       // of more than 0.3 s: without a command for so long the arm stands
  kOfAnotherWriter  // whose pictures and time have nothing to do with those before
};

class PictureClock {
 public:
  // The picture has been acted on, or one of its writer that is newer.
  bool has_passed(const PoseSample& pose) const;
  // Goes on to a picture that it has not passed.
  Succession advance(const PoseSample& pose);
  // The next picture begins another time, whoever writes it.
  void begin_anew();

  // s, frame interval; within what a step may fill
  double seconds() const { return seconds_; }

 private:
  std::int64_t session_ = 0;  // of the frames' writer
  std::int64_t utime_ = 0;    // us, of the picture that was acted on last
  double seconds_ = 1.0 / 30.0;
};

}  // namespace markservo::visual_servo
