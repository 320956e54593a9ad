#pragma once

#include <cstdint>
#include <vector>

namespace markservo::campaign {

// The world's time as it passed for who listened: seconds that only grow, whatever clocks are set to. The simulator may
// be slower than real time.
class WorldClock {
 public:
  // The simulator's stamp `utime` was heard at `t`; both us.
  void heard(std::int64_t t, std::int64_t utime);
  // s; the last stamp's before `t`.
  double at(std::int64_t t) const;

 private:
  struct Tick {
    std::int64_t t = 0;
    std::int64_t utime = 0;
    double seconds = 0.0;
  };
  std::vector<Tick> ticks_;
};

}  // namespace markservo::campaign
