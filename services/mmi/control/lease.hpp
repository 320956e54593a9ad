#pragma once

#include <cstdint>

namespace markservo::mmi {

// Who is the one operator. No clock: `now` is s of any steady clock.
class Lease {
 public:
  static constexpr double kLasts = 5.0;  // s after the holder's last word, of one a second

  // `client` wants to hold it, or to go on; `take`: also from another, else another's stays.
  void hold(std::int64_t client, bool take, double now);
  void give_up(std::int64_t client);

  // Whoever holds it at `now`; 0: nobody.
  std::int64_t holder(double now) const;
  // s, when the holder got it.
  double since() const { return since_; }

 private:
  std::int64_t holder_ = 0;
  double since_ = 0.0;
  double heard_ = 0.0;
};

}  // namespace markservo::mmi
