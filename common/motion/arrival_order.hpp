#pragma once

// Whether a message of one writer comes in its turn. UDP, bridges and bad links deliver late, twice and out of order;
// that is no new beginning, while a clock that was set back is one.

#include <cstddef>
#include <cstdint>
#include <deque>

#include "common/motion/stamp.hpp"

namespace markservo::motion {

enum class Arrival {
  kNext,    // goes on from the one before, or is the first
  kLate,    // comes late, twice or out of turn: to be dropped
  kAnew,    // the writer's numbers or its clock began anew: what is known of before no longer holds
  kDouble,  // numbered as an earlier one, yet of another time or content: two write with one session
};

struct ArrivalParameters {
  double clock_step = 1.0;  // s; a time so far back, under a growing number, is a clock that was set back
  int run = 3;              // messages out of turn, each above the one before, that are a new beginning
};

// One writer's messages on one channel. The session is the caller's matter.
//
// | number      | time                 | verdict                               |
// | ----------- | -------------------- | ------------------------------------- |
// | above       | at or above the last | next                                  |
// | above       | below, by up to 1 s  | late                                  |
// | above       | below, by more       | anew                                  |
// | not above   | not above            | late; however many, when over 1 s back |
// | taken, of late | another, or says something else | double                  |
// | not above   | above                | double                                |
// | the third late or double one in a row, each above the one before in both | | anew: the writer is alone again |
class ArrivalOrder {
 public:
  explicit ArrivalOrder(ArrivalParameters parameters = {}) : parameters_(parameters) {}

  Arrival hear(const Stamp& stamp);

  bool empty() const { return empty_; }
  // The newest one that was in turn; meaningless while empty.
  const Stamp& last() const { return last_; }
  // Nothing is known of the writer any more.
  void forget() { *this = ArrivalOrder(parameters_); }

 private:
  Arrival accept(const Stamp& stamp, Arrival arrival);
  Arrival out_of_turn(const Stamp& stamp, Arrival verdict);
  bool taken_otherwise(const Stamp& stamp) const;

  static constexpr std::size_t kTaken = 64;  // 0.6 s of the quickest channel: more than links delay

  ArrivalParameters parameters_;
  bool empty_ = true;
  Stamp last_;
  std::deque<Stamp> taken_;  // the last ones, the newest at the end
  int run_ = 0;              // late or double ones in a row, each above the one before
  Stamp run_last_;
};

}  // namespace markservo::motion
